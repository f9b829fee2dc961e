// The README's examples, as strict TypeScript sees them with the types of three.js, all declarations checked.
//
//   node readme_types_test.mjs PACKAGE README MODULES FOLDER    MODULES has typescript, three and their types
import assert from "node:assert/strict";
import { spawnSync } from "node:child_process";
import { mkdirSync, readFileSync, rmSync, symlinkSync, writeFileSync } from "node:fs";
import { join } from "node:path";

const [npm, readme, modules, folder] = process.argv.slice(2);
const examples = [...readFileSync(readme, "utf8").matchAll(/^```js\n(.*?)^```/gms)].map((found) => found[1]);
assert.equal(examples.length, 3, "examples of the README");

rmSync(folder, { recursive: true, force: true });
mkdirSync(join(folder, "node_modules/@types"), { recursive: true });
symlinkSync(npm, join(folder, "node_modules/haptic-retargeting"));
for (const name of ["three", "@types/three", "@types/webxr"]) symlinkSync(join(modules, name), join(folder, "node_modules", name));
writeFileSync(join(folder, "package.json"), '{ "type": "module" }');
writeFileSync(join(folder, "reach.ts"), examples[0]);
writeFileSync(join(folder, "hand.ts"), `import type { Session, TargetId } from "haptic-retargeting";
import type { Camera, Scene, WebGLRenderer } from "three";
declare const session: Session, cylinder: TargetId, cup: TargetId, scene: Scene, camera: Camera, renderer: WebGLRenderer;
${examples[2]}`);
for (const [module, resolution] of [["es2022", "bundler"], ["node16", "node16"]]) {
  const { status, stdout } = spawnSync(process.execPath, [join(modules, "typescript/lib/tsc.js"), "--noEmit", "--strict",
    "--preserveSymlinks", "--target", "es2022", "--lib", "es2022,dom,dom.iterable", "--module", module, "--moduleResolution", resolution,
    "reach.ts", "hand.ts"], { cwd: folder, encoding: "utf8" });
  assert.equal(status, 0, `${resolution}:\n${stdout}`);
}

// Runs the reach in node.
//   usage: node run.mjs FOLDER_OF_THE_PACKAGE
import { pathToFileURL } from "node:url";
import { runReach } from "./reach.mjs";

const [, , folder] = process.argv;
const hrt = await import(pathToFileURL(`${folder}/node.mjs`));
const { hash, summary } = runReach(hrt, await hrt.load());
console.log(`hash ${hash}`);
console.log(`miss ${summary.miss_deg.toFixed(2)} deg (simulated)`);

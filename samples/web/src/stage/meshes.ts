// Reads the meshes of a visitor's scene, whose plate and targets the plugin's loader has read. Nothing is fetched:
// meshes and textures come from the opened files.
import { Group, LoadingManager, Matrix4, Mesh, type Object3D, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/** More vertices would make each frame of the page slow. */
const maxDrawn = 2_000_000;

export interface SceneMeshes {
  readonly group: Group;
  /** Names of the targets that have a mesh. */
  readonly targets: ReadonlySet<string>;
}

/** Reads the meshes of a glTF file in plate coordinates, without the plate's own. `files`: the opened files by name. */
export async function readMeshes(
  bytes: ArrayBuffer,
  files: ReadonlyMap<string, File>,
  platePosition_m: readonly number[],
  plateRotation: readonly number[],
): Promise<SceneMeshes> {
  const manager = new LoadingManager(),
    urls: string[] = [];
  manager.setURLModifier((url) => {
    if (/^(data|blob):/.test(url)) return url;
    const file = files.get(url) ?? files.get(decodeURI(url));
    if (!file) throw new Error("its meshes lie in another file: open or drop it together with this one");
    urls.push(URL.createObjectURL(file));
    return urls.at(-1)!;
  });
  const { scene } = await new GLTFLoader(manager)
    .parseAsync(bytes, "")
    .finally(() => urls.forEach(URL.revokeObjectURL));

  const names = new Set<string>(),
    left: Object3D[] = [];
  let drawn = 0;
  scene.traverse((node) => {
    if (node instanceof Mesh) drawn += node.geometry.index?.count ?? node.geometry.attributes.position?.count ?? 0;
    const { haptic } = node.userData as { haptic?: { role?: unknown; name?: unknown } };
    if (haptic?.role === "plate") left.push(...node.children.filter((child) => !child.userData.haptic), node);
    else if (haptic && node.getObjectByProperty("isMesh", true))
      names.add(typeof haptic.name === "string" ? haptic.name : node.name);
  });
  if (drawn > maxDrawn)
    throw new Error(`they draw ${drawn} vertices; up to ${maxDrawn} are allowed: simplify the scene`);
  for (const node of left) if (node instanceof Mesh) node.visible = false;
  const position = new Vector3().fromArray(platePosition_m),
    pose = new Matrix4().compose(position, new Quaternion().fromArray(plateRotation), new Vector3(1, 1, 1));
  const group = new Group().add(scene);
  scene.applyMatrix4(pose.invert());
  return { group, targets: names };
}

// Reads the meshes of a visitor's scene, whose plate and targets the plugin's loader has read. Nothing is fetched: the meshes come
// from the opened files, without textures, animations and skins.
import { Group, Matrix4, Mesh, type Object3D, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

/** Parts of a glTF file that are used. */
const kept = ["asset", "scene", "scenes", "nodes", "materials", "meshes", "accessors", "bufferViews", "buffers"];

/** Larger scenes would block the page. */
const maxNodes = 10_000,
  maxValues = 4_000_000,
  maxDrawn = 2_000_000;

type Json = Record<string, unknown>;

export interface SceneMeshes {
  /** Meshes in plate coordinates, in metres. */
  readonly group: Group;
  /** Names of the targets that have a mesh. */
  readonly targets: ReadonlySet<string>;
}

/** Reads the file's meshes, with its plate at the origin and without the plate's mesh. `others`: files that were opened with it,
 *  by name. Rejects if they cannot be read. */
export async function readMeshes(
  bytes: ArrayBuffer,
  others: ReadonlyMap<string, ArrayBuffer>,
  platePosition_m: readonly number[],
  plateRotation: readonly number[],
): Promise<SceneMeshes> {
  const loader = new GLTFLoader();
  loader.register((parser) => {
    restrict(parser.json);
    const views = list(parser.json.bufferViews),
      buffers = list(parser.json.buffers).map(({ uri }) => (uri === undefined ? null : buffer(uri, others)));
    return {
      name: "embedded buffers",
      loadBufferView: async (index: number) => {
        const { buffer, byteOffset, byteLength } = views[index] ?? {},
          content: ArrayBuffer =
            buffers[Number(buffer)] ?? parser.extensions.KHR_binary_glTF?.body ?? new ArrayBuffer(0),
          from = Number(byteOffset ?? 0);
        return content.slice(from, from + Number(byteLength));
      },
    };
  });
  const { scene } = await loader.parseAsync(bytes, "");

  const names = new Set<string>(),
    left: Object3D[] = [];
  scene.traverse((node) => {
    const { haptic } = node.userData as { haptic?: { role?: unknown; name?: unknown } };
    if (haptic?.role === "plate") left.push(...node.children.filter((child) => !child.userData.haptic), node);
    else if (haptic && node.getObjectByProperty("isMesh", true))
      names.add(typeof haptic.name === "string" ? haptic.name : node.name);
  });
  for (const node of left) if (node instanceof Mesh) node.visible = false;
  const position = new Vector3().fromArray(platePosition_m),
    pose = new Matrix4().compose(position, new Quaternion().fromArray(plateRotation), new Vector3(1, 1, 1));
  const group = new Group().add(scene);
  scene.applyMatrix4(pose.invert());
  return { group, targets: names };
}

/** Removes what is not used, and checks the limits. Throws above them. */
function restrict(file: Json): void {
  for (const name of Object.keys(file)) if (!kept.includes(name)) delete file[name];
  file.materials = list(file.materials).map((material) => ({
    ...pick(material, ["name", "doubleSided", "alphaMode", "alphaCutoff", "emissiveFactor"]),
    pbrMetallicRoughness: pick(material.pbrMetallicRoughness, ["baseColorFactor", "metallicFactor", "roughnessFactor"]),
  }));
  const used = ["name", "children", "mesh", "matrix", "translation", "rotation", "scale", "extras"];
  file.nodes = list(file.nodes).map((node) => pick(node, used));
  const values = list(file.accessors).reduce((sum, { count }) => sum + Number(count), 0);
  if (!(values <= maxValues) || list(file.nodes).length > maxNodes)
    throw new Error(`they have more than ${maxValues} values or ${maxNodes} nodes; simplify the scene`);
  const drawn = drawnVertices(file);
  if (!(drawn <= maxDrawn))
    throw new Error(`they draw ${drawn} vertices; up to ${maxDrawn} are allowed: simplify the scene`);
}

/** Number of vertices of all nodes: a mesh counts once for each node that uses it. */
function drawnVertices(file: Json): number {
  const counts = list(file.accessors).map(({ count }) => Number(count));
  const count = (index: unknown): number => (index === undefined ? 0 : (counts[Number(index)] ?? NaN));
  const ofPrimitive = ({ attributes, indices }: Json): number =>
    Math.max(count((attributes as Json | undefined)?.POSITION), count(indices));
  const ofMesh = list(file.meshes).map(({ primitives }) =>
    list(primitives).reduce((sum, primitive) => sum + ofPrimitive(primitive), 0),
  );
  return list(file.nodes).reduce((sum, { mesh }) => sum + (mesh === undefined ? 0 : (ofMesh[Number(mesh)] ?? 0)), 0);
}

function buffer(uri: unknown, others: ReadonlyMap<string, ArrayBuffer>): ArrayBuffer {
  const other = typeof uri === "string" ? (others.get(uri) ?? others.get(decodeURI(uri))) : undefined;
  if (other) return other;
  const base64 = typeof uri === "string" ? /^data:[^,]*;base64,(.*)$/s.exec(uri)?.[1] : undefined;
  if (base64 === undefined) throw new Error("its meshes lie in another file: open or drop it together with this one");
  return Uint8Array.from(atob(base64), (byte) => byte.charCodeAt(0)).buffer;
}

function list(value: unknown): Json[] {
  return Array.isArray(value) ? value.filter(isJson) : [];
}

function isJson(value: unknown): value is Json {
  return typeof value === "object" && value !== null;
}

function pick(from: unknown, names: readonly string[]): Json {
  if (!isJson(from)) return {};
  return Object.fromEntries(names.filter((name) => from[name] !== undefined).map((name) => [name, from[name]]));
}

// Draws the meshes of a visitor's scene, whose plate and targets the plugin's loader has read before. Nothing is fetched: only
// the content of the file is used, without textures, animations and skins.
import { Group, Matrix4, Mesh, type Object3D, Quaternion, Vector3 } from "three";
import { GLTFLoader } from "three/addons/loaders/GLTFLoader.js";

const glbMagic = 0x46546c67,
  jsonChunk = 0x4e4f534a,
  binaryChunk = 0x004e4942;

/** Properties of a glTF file that are used, in addition to its nodes and materials. */
const kept = ["asset", "scene", "scenes", "meshes", "accessors", "bufferViews", "buffers"] as const;

/** Limits of a scene, above which the page would not respond. */
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
  const { json, binary } = parts(bytes),
    file = pick(json, kept);
  file.materials = list(json.materials).map((material) => ({
    ...pick(material, ["name", "doubleSided", "alphaMode", "alphaCutoff", "emissiveFactor"]),
    pbrMetallicRoughness: pick(material.pbrMetallicRoughness, ["baseColorFactor", "metallicFactor", "roughnessFactor"]),
  }));
  file.nodes = list(json.nodes).map((node) =>
    pick(node, ["name", "children", "mesh", "matrix", "translation", "rotation", "scale", "extras"]),
  );
  const values = list(json.accessors).reduce((sum, { count }) => sum + Number(count), 0);
  if (!(values <= maxValues) || list(file.nodes).length > maxNodes)
    throw new Error(`they have more than ${maxValues} values or ${maxNodes} nodes`);
  const drawn = drawnVertices(file);
  if (!(drawn <= maxDrawn))
    throw new Error(
      `they draw ${drawn} vertices, each mesh as often as it stands there; up to ${maxDrawn} are allowed`,
    );
  const buffers = list(json.buffers).map(({ uri }) => (uri === undefined ? binary : buffer(uri, others)));
  const views = list(json.bufferViews);

  const loader = new GLTFLoader();
  loader.register(() => ({
    name: "embedded buffers",
    loadBufferView: (index: number) => {
      const { buffer, byteOffset = 0, byteLength } = views[index] ?? {},
        from = Number(byteOffset);
      return Promise.resolve((buffers[Number(buffer)] ?? new ArrayBuffer(0)).slice(from, from + Number(byteLength)));
    },
  }));
  // parseAsync also accepts parsed JSON, which its type declaration lacks.
  const { scene } = await loader.parseAsync(file as unknown as string, "");

  const names = new Set<string>(),
    left: Object3D[] = [];
  scene.traverse((node) => {
    const { haptic } = node.userData as { haptic?: { role?: unknown; name?: unknown } };
    if (haptic?.role === "plate") left.push(...node.children.filter((child) => !child.userData.haptic), node);
    else if (haptic && node.getObjectByProperty("isMesh", true))
      names.add(typeof haptic.name === "string" ? haptic.name : node.name);
  });
  for (const node of left) if (node instanceof Mesh) node.visible = false;
  const pose = new Matrix4().compose(
    new Vector3().fromArray(platePosition_m),
    new Quaternion().fromArray(plateRotation),
    new Vector3(1, 1, 1),
  );
  const group = new Group();
  group.add(scene);
  scene.applyMatrix4(pose.invert());
  return { group, targets: names };
}

function parts(bytes: ArrayBuffer): { json: Json; binary: ArrayBuffer } {
  const view = new DataView(bytes);
  if (bytes.byteLength < 20 || view.getUint32(0, true) !== glbMagic) {
    return { json: JSON.parse(new TextDecoder().decode(bytes)) as Json, binary: new ArrayBuffer(0) };
  }
  let json: Json = {},
    binary = new ArrayBuffer(0);
  for (let at = 12; at + 8 <= bytes.byteLength; ) {
    const length = view.getUint32(at, true),
      type = view.getUint32(at + 4, true),
      chunk = bytes.slice(at + 8, at + 8 + length);
    if (type === jsonChunk) json = JSON.parse(new TextDecoder().decode(chunk)) as Json;
    else if (type === binaryChunk) binary = chunk;
    at += 8 + length;
  }
  return { json, binary };
}

/** Number of vertices of all nodes: a mesh counts once for each node that uses it. */
function drawnVertices(file: Json): number {
  const counts = list(file.accessors).map(({ count }) => Number(count));
  const count = (index: unknown): number => (index === undefined ? 0 : (counts[Number(index)] ?? NaN));
  const ofMesh = list(file.meshes).map(({ primitives }) =>
    list(primitives).reduce(
      (sum, { attributes, indices }) =>
        sum + Math.max(count((attributes as Json | undefined)?.POSITION), count(indices)),
      0,
    ),
  );
  return list(file.nodes).reduce((sum, { mesh }) => sum + (mesh === undefined ? 0 : (ofMesh[Number(mesh)] ?? 0)), 0);
}

function buffer(uri: unknown, others: ReadonlyMap<string, ArrayBuffer>): ArrayBuffer {
  const other = typeof uri === "string" ? (others.get(uri) ?? others.get(decodeURI(uri))) : undefined;
  if (other) return other;
  const base64 = typeof uri === "string" ? /^data:[^,]*;base64,(.*)$/s.exec(uri)?.[1] : undefined;
  if (base64 === undefined) throw new Error("its meshes lie in another file: drop it together with this one");
  const text = atob(base64),
    bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes.buffer;
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

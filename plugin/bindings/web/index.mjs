// The plugin for browsers and bundlers. Types and documentation: index.d.ts; fields of structs: abi.d.ts.
import * as abi from "./abi.js";
import { Command, readCommand, readSample, Sample, writeSample } from "./frame.mjs";
import { HapticRetargetingError, Host, Memory, readText } from "./memory.mjs";
import { checked } from "./numbers.mjs";
import { positionOf, rotationOf } from "./pose.mjs";
export * from "./abi.js";
export { HapticRetargetingError };

export async function load(source) {
  const host = new Host();
  const { instance } = await instantiate(source, host.imports());
  host.attach(instance);
  const library = new Library(new Memory(host, instance.exports));
  const { major, minor, patch } = library.version;
  if (major !== abi.HRT_VERSION_MAJOR || minor !== abi.HRT_VERSION_MINOR) {
    throw new Error(`the module has version ${major}.${minor}.${patch}, this package version ` +
                    `${abi.HRT_VERSION_MAJOR}.${abi.HRT_VERSION_MINOR}: load the haptic_retargeting.wasm of this package`);
  }
  return library;
}

async function instantiate(source, imports) {
  if (source instanceof WebAssembly.Module) return { instance: await WebAssembly.instantiate(source, imports) };
  if (ArrayBuffer.isView(source) || source instanceof ArrayBuffer) return WebAssembly.instantiate(source, imports);
  const url = source ?? new URL("./haptic_retargeting.wasm", import.meta.url);
  if (String(url).startsWith("file:")) {
    throw new Error(`${url} is a file, which a page cannot fetch: serve it, or pass its bytes to load(). In node, import ` +
                    '"haptic-retargeting" or its node.mjs.');
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`the module cannot be loaded: ${response.url}: ${response.status} ${response.statusText}; serve the file there, or pass its address or its bytes to load()`);
  const streamed = response.headers.get("content-type")?.startsWith("application/wasm");
  return streamed ? WebAssembly.instantiateStreaming(response, imports) : WebAssembly.instantiate(await response.arrayBuffer(), imports);
}

class Library {
  #memory;
  constructor(memory) { this.#memory = memory; }

  get version() {
    return this.#memory.with(12, (at) => {
      this.#memory.entry("hrt_get_version")(at, at + 4, at + 8);
      const part = (i) => this.#memory.view.getUint32(at + 4 * i, true);
      return { major: part(0), minor: part(1), patch: part(2) };
    });
  }

  createSession(config = {}) { return new Session(this.#memory, config); }
  createPerson(seed = 0, config = {}) { return new Person(this.#memory, seed, config); }
  loadScene(bytes, name = "scene") { return new Scene(this.#memory, bytes, name); }

  replay(text) {
    return this.#memory.withText(text, (at, length) =>
      this.#memory.get("hrt_replay_report", "hrt_recording_replay", 0, at, length));
  }
}

// The library writes a handle, an id or a count as one u64.
function created(memory, create) { return idsOf(memory, 1, create)[0]; }
function idsOf(memory, count, write) {
  return memory.with(8 * count + 1, (at) => {
    write(at);
    return Array.from({ length: count }, (_, i) => memory.view.getBigUint64(at + 8 * i, true));
  });
}

/** Checks the id of a target, and converts it for the module. `name`: argument that errors name. */
const idOf = (target, name = "target") => checked(name, "id", target);

// An object of the module: its handle, and structs in the module's memory that exist as long as the object.
class Native {
  #destroyed = false;
  #destroy;
  #structs = new Map();
  /** `destroy`: call that destroys the object, such as hrt_session_destroy; `types`: types of the structs. */
  constructor(memory, destroy, create, ...types) {
    this.memory = memory;
    this.#destroy = destroy;
    this.handle = created(memory, create);
    for (const type of types) this.#structs.set(type, memory.allocateStruct(type));
  }
  call(name, ...values) { this.memory.call(name, this.handle, ...values); }
  get(type, name, ...values) { return this.memory.get(type, name, this.handle, ...values); }
  put(type, fields, name, ...values) { this.memory.put(type, fields, name, this.handle, ...values); }
  at(type) {
    const at = this.#structs.get(type);
    if (at === undefined) throw new HapticRetargetingError(abi.HRT_ERROR_INVALID_HANDLE, `the ${this.#destroy.split("_")[1]} has been destroyed; create another one`);
    return at;
  }
  destroy() {
    if (this.#destroyed) return;
    this.call(this.#destroy);
    this.#destroyed = true;
    for (const at of this.#structs.values()) this.memory.free(at);
    this.#structs.clear();
  }
}

function shown(object, name, value) { Object.defineProperty(object, name, { value, enumerable: true }); }

// `using` destroys an object by its method of this name. Where Symbol.dispose is missing, compilers use Symbol.for().
const dispose = Symbol.dispose ?? Symbol.for("Symbol.dispose");

class Session {
  static #count = 0;
  #native;
  #update;
  #registered = false;
  #path = `recording ${++Session.#count}`;

  constructor(memory, config) {
    this.#native = memory.withStruct("hrt_session_config", config, (at) =>
      new Native(memory, "hrt_session_destroy", (out) => memory.call("hrt_session_create", abi.HRT_VERSION, at, out), "hrt_sample", "hrt_command"));
    this.#update = memory.entry("hrt_reach_update");
    shown(this, "sample", new Sample());
    shown(this, "command", new Command());
  }

  get handle() { return this.#native.handle; }

  destroy() {
    this.#native.destroy();
    Object.freeze(this.sample);
  }
  [dispose]() { this.destroy(); }

  get config() {
    return this.#native.memory.output("hrt_session_config", (at) => this.#native.call("hrt_session_get", at, 0));
  }
  configure(changes) { this.#native.put("hrt_session_config", { ...this.config, ...changes }, "hrt_session_set"); }

  setPlate(pose) {
    const at = positionOf(pose), turned = at && rotationOf(pose);
    if (!turned) throw new TypeError("the plate's pose lacks a finite position or a rotation; pass an XRRigidTransform or an object of three.js");
    const flags = this.config.flags & ~abi.HRT_SESSION_REGISTERED;
    this.configure({ plate_position_m: [at.x, at.y, at.z], plate_rotation: [turned.x, turned.y, turned.z, turned.w], flags });
  }

  addTarget(config) {
    const { memory } = this.#native;
    return memory.withStruct("hrt_target_config", config, (at) =>
      Number(created(memory, (out) => this.#native.call("hrt_target_add", at, out))));
  }
  target(id) { return this.#native.get("hrt_target_config", "hrt_target_get", idOf(id)); }
  setTarget(id, changes) { this.#native.put("hrt_target_config", { ...this.target(id), ...changes }, "hrt_target_set", idOf(id)); }
  removeTarget(id) { this.#native.call("hrt_target_remove", idOf(id)); }
  findTarget(name) {
    const found = this.targets().find((id) => this.target(id).name === name);
    if (found === undefined) throw new RangeError(`no target has the name "${name}"; addTarget() gives a target its name`);
    return found;
  }
  targets(role = 0) {
    const { memory } = this.#native, list = (capacity, ids) =>
      created(memory, (count) => this.#native.call("hrt_target_list", role, capacity, ids, count));
    const capacity = list(0n, 0);
    return idsOf(memory, Number(capacity), (ids) => list(capacity, ids)).map(Number);
  }

  gap(realTarget, virtualTarget) {
    return this.#native.get("hrt_gap", "hrt_gap_query", idOf(realTarget, "realTarget"), idOf(virtualTarget, "virtualTarget"));
  }

  assign(virtualTargets, realTargets, exclusive = false) {
    const { memory } = this.#native, count = virtualTargets.length, { size } = abi.structs.hrt_gap;
    const ids = [...virtualTargets, ...realTargets].map((id) => idOf(id));
    return memory.with(8 * ids.length + 1, (at) => memory.with(size * count + 4, (out) => {
      ids.forEach((id, i) => memory.view.setBigUint64(at + 8 * i, id, true));
      memory.view.setUint32(out, size, true);
      this.#native.call("hrt_gap_assign", at, BigInt(count), at + 8 * count, BigInt(realTargets.length),
        exclusive ? abi.HRT_ASSIGN_EXCLUSIVE : 0, BigInt(count), out);
      return Array.from({ length: count }, (_, i) => memory.read("hrt_gap", out + size * i));
    }));
  }

  get state() {
    const { memory } = this.#native;
    return memory.with(4, (at) => {
      this.#native.call("hrt_session_get", 0, at);
      return memory.view.getUint32(at, true);
    });
  }

  beginReach(realTarget, virtualTarget, plateOrientationDeg, startAtFinger = false) {
    const flags = (plateOrientationDeg === undefined ? 0 : abi.HRT_REACH_PLATE_ORIENTATION) |
                  (startAtFinger ? abi.HRT_REACH_START_AT_FINGER : 0);
    this.#native.put("hrt_reach_config", { real_target: realTarget, virtual_target: virtualTarget, flags,
                                           plate_orientation_deg: plateOrientationDeg }, "hrt_reach_begin");
    this.#registered = (this.config.flags & abi.HRT_SESSION_REGISTERED) !== 0;
  }
  get registered() { return this.#registered; }
  retargetReach(realTarget, virtualTarget) {
    this.#native.call("hrt_reach_retarget", idOf(realTarget, "realTarget"), idOf(virtualTarget, "virtualTarget"));
  }
  reachTouched(contact = {}) { this.#native.put("hrt_contact", contact, "hrt_reach_touched"); }
  cancelReach() {
    this.#native.call("hrt_reach_cancel");
    this.#log();
  }
  /** Writes the log lines that updates have stored because they may not block. */
  #log() {
    this.#native.call("hrt_host_set_log", 0);
  }
  setFinger(pose, time_ms) {
    if (!Number.isFinite(time_ms)) {
      throw new RangeError(`time_ms is ${String(time_ms)}; a finite number is needed, such as the time that the frame's callback is given`);
    }
    const { sample } = this, at = positionOf(pose);
    sample.time_ns = time_ms * 1e6;
    sample.flags = at ? abi.HRT_SAMPLE_WORLD_POSITION : 0;
    if (!at) return;
    const { finger_position_m: position, joint_rotation: rotation } = sample, turned = rotationOf(pose);
    position[0] = at.x;
    position[1] = at.y;
    position[2] = at.z;
    if (!turned) return;
    sample.flags |= abi.HRT_SAMPLE_JOINT_ROTATION;
    rotation[0] = turned.x;
    rotation[1] = turned.y;
    rotation[2] = turned.z;
    rotation[3] = turned.w;
  }
  update() {
    const { memory, handle } = this.#native, input = this.#native.at("hrt_sample"), output = this.#native.at("hrt_command");
    writeSample(memory.view, input, this.sample);
    const code = this.#update(handle, input, output);
    if (code !== abi.HRT_OK) memory.fail(code);
    readCommand(memory.view, output, this.command);
  }
  endReach() {
    const summary = this.#native.get("hrt_reach_summary", "hrt_reach_end");
    this.#log();
    return summary;
  }

  get profile() {
    const { memory } = this.#native, save = (capacity, text) =>
      created(memory, (length) => this.#native.call("hrt_profile_save", capacity, text, length));
    const capacity = save(0n, 0) + 1n;
    return memory.with(Number(capacity), (text) => {
      save(capacity, text);
      return readText(memory.view.buffer, text);
    });
  }
  loadProfile(text) {
    this.#native.memory.withText(text, (at, length) => this.#native.call("hrt_profile_load", at, length));
  }

  get conditions() { return this.#native.get("hrt_conditions", "hrt_profile_get_conditions"); }
  setConditions(conditions) {
    this.#native.put("hrt_conditions", conditions, "hrt_profile_set_conditions");
  }

  beginSetup(what = abi.HRT_SETUP_ALL_MISSING, config = {}) {
    this.#native.put("hrt_setup_config", config, "hrt_setup_begin", what);
  }
  updateSetup() {
    const input = this.#native.at("hrt_sample");
    writeSample(this.#native.memory.view, input, this.sample);
    return this.#native.get("hrt_setup_step", "hrt_setup_update", input);
  }
  finishSetup() { return this.#native.get("hrt_setup_result", "hrt_setup_finish"); }
  cancelSetup() { this.#native.call("hrt_setup_cancel"); }

  newPerson() { this.#native.call("hrt_profile_reset"); }

  startRecording() {
    this.#native.memory.withText(this.#path, (at) => this.#native.call("hrt_recording_start", at));
  }
  get recordingStatus() { return this.#native.get("hrt_recording_status", "hrt_recording_get_status"); }
  stopRecording() {
    this.#native.get("hrt_recording_status", "hrt_recording_stop");
    return this.#native.memory.takeFile(this.#path);
  }
}

class Person {
  #native;

  constructor(memory, seed, config) {
    this.#native = memory.withStruct("hrt_person_config", config, (at) =>
      new Native(memory, "hrt_person_destroy", (out) => memory.call("hrt_person_create", at, checked("seed", "u64", seed), out), "hrt_sample"));
  }

  destroy() { this.#native.destroy(); }
  [dispose]() { this.destroy(); }

  begin(session, virtualTarget = 0) {
    this.#native.call("hrt_person_begin", session.handle, idOf(virtualTarget, "virtualTarget"));
  }
  move(sample, time_ns, plateOrientationDeg) {
    const out = this.#native.at("hrt_sample");
    this.#native.call("hrt_person_move", checked("time_ns", "i64", Math.round(time_ns)),
      checked("plateOrientationDeg", "f64", plateOrientationDeg), out);
    readSample(this.#native.memory.view, out, sample);
  }
  get state() { return this.#native.get("hrt_person_state", "hrt_person_get_state"); }
}

class Scene {
  #native;

  constructor(memory, bytes, name) {
    this.#native = memory.withText(name, (text) => memory.withBytes(new Uint8Array(bytes), (at, length) =>
      new Native(memory, "hrt_scene_destroy", (out) => memory.call("hrt_scene_load", text, at, length, out))));
  }

  destroy() { this.#native.destroy(); }
  [dispose]() { this.destroy(); }

  get info() { return this.#native.get("hrt_scene_info", "hrt_scene_get_info"); }
  get targets() {
    return Array.from({ length: this.info.target_count }, (_, i) => this.#native.get("hrt_scene_target", "hrt_scene_get_target", i));
  }
  register(session) {
    const count = this.info.target_count;
    return idsOf(this.#native.memory, count, (ids) => this.#native.call("hrt_scene_register", session.handle, BigInt(count), ids)).map(Number);
  }
}

// The plugin for browsers and node: loads the WebAssembly module and wraps its C functions. Types and
// documentation: index.d.ts; fields of structs: abi.d.ts.
import * as abi from "./abi.js";
export * from "./abi.js";

const resultNames = new Map(Object.entries(abi)
  .filter(([name]) => name === "HRT_OK" || name.startsWith("HRT_ERROR_"))
  .map(([name, code]) => [code, name]));

export class HapticRetargetingError extends Error {
  constructor(code, message) {
    super(message);
    this.name = "HapticRetargetingError";
    this.code = code;
    this.codeName = resultNames.get(code) ?? "unknown result";
  }
}

export async function load(source) {
  const host = new Host();
  const { instance } = await instantiate(source, host.imports());
  host.attach(instance);
  const library = new Library(new Memory(host, instance.exports));
  const { major, minor, patch } = library.version;
  if (major !== abi.HRT_VERSION_MAJOR || minor !== abi.HRT_VERSION_MINOR) {
    throw new Error(`the module is version ${major}.${minor}.${patch}; this package is of ` +
                    `${abi.HRT_VERSION_MAJOR}.${abi.HRT_VERSION_MINOR}: load the module that came with it`);
  }
  return library;
}

async function instantiate(source, imports) {
  if (source instanceof WebAssembly.Module) return { instance: await WebAssembly.instantiate(source, imports) };
  if (ArrayBuffer.isView(source) || source instanceof ArrayBuffer) return WebAssembly.instantiate(source, imports);
  const url = source ?? new URL("./haptic_retargeting.wasm", import.meta.url);
  if (new URL(url, import.meta.url).protocol === "file:") {
    const { readFile } = await import(/* webpackIgnore: true */ "node:fs/promises");
    return WebAssembly.instantiate(await readFile(new URL(url, import.meta.url)), imports);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${response.url}: ${response.status} ${response.statusText}`);
  return WebAssembly.instantiate(await response.arrayBuffer(), imports);
}

// What the module asks of its surroundings: files, which are kept in memory.
const EBADF = 8, ENOENT = 44, ENOSYS = 52;

class Host {
  files = new Map();  // what was written, by path
  #open = new Map();  // the same by descriptor
  #nextDescriptor = 3;
  #memory;
  onMemoryGrowth = () => {};

  imports() {
    const refuse = () => EBADF;
    return {
      env: {
        emscripten_notify_memory_growth: () => this.onMemoryGrowth(),
        hrt_web_open: (path, writes) => this.#openFile(path, writes),
      },
      wasi_snapshot_preview1: {
        fd_write: (fd, parts, count, written) => this.#write(fd, parts, count, written),
        fd_close: (fd) => (this.#open.delete(fd) ? 0 : EBADF),
        fd_read: refuse,
        fd_seek: refuse,
        fd_fdstat_get: refuse,
        clock_time_get: () => ENOSYS,
        environ_sizes_get: (count, size) => this.#zero(count, size),
        environ_get: () => 0,
        proc_exit: (code) => { throw new Error(`the module ended with ${code}`); },
      },
    };
  }

  attach(instance) {
    this.#memory = instance.exports.memory;
    instance.exports._initialize();
  }

  #openFile(path, writes) {
    if (!writes) return -ENOENT;
    const file = { parts: [] };
    this.files.set(readText(this.#memory.buffer, path), file);
    this.#open.set(this.#nextDescriptor, file);
    return this.#nextDescriptor++;
  }

  #write(fd, parts, count, written) {
    const file = this.#open.get(fd);
    if (!file) return EBADF;
    const view = new DataView(this.#memory.buffer);
    let total = 0;
    for (let i = 0; i < count; ++i) {
      const at = view.getUint32(parts + 8 * i, true), length = view.getUint32(parts + 8 * i + 4, true);
      file.parts.push(new Uint8Array(this.#memory.buffer, at, length).slice());
      total += length;
    }
    view.setUint32(written, total, true);
    return 0;
  }

  #zero(...pointers) {
    const view = new DataView(this.#memory.buffer);
    for (const pointer of pointers) view.setUint32(pointer, 0, true);
    return 0;
  }
}

const encoder = new TextEncoder(), decoder = new TextDecoder();

function readText(buffer, at) {
  const bytes = new Uint8Array(buffer, at);
  return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
}

// How a field's type is read and written; `least` and `most` are what is allowed of integers.
const types = {
  u8: { size: 1 },
  u32: { size: 4, least: 0, most: 2 ** 32 - 1, get: "getUint32", set: "setUint32" },
  i32: { size: 4, least: -(2 ** 31), most: 2 ** 31 - 1, get: "getInt32", set: "setInt32" },
  u64: { size: 8, least: 0n, most: 2n ** 64n - 1n, get: "getBigUint64", set: "setBigUint64" },
  i64: { size: 8, least: -(2n ** 63n), most: 2n ** 63n - 1n, get: "getBigInt64", set: "setBigInt64" },
  f64: { size: 8, get: "getFloat64", set: "setFloat64" },
};

// Checks here what assigning to memory would silently change; ranges are the library's to check.
function checked(name, type, value) {
  const { least, most } = types[type];
  if (type === "f64") {
    if (typeof value !== "number") throw new TypeError(`${name} is ${String(value)}; a number is needed`);
    return value;
  }
  const wide = typeof least === "bigint";
  const whole = typeof value === "bigint" || Number.isSafeInteger(value);
  if (!whole || value < least || value > most) {
    throw new RangeError(`${name} is ${String(value)}; a whole number from ${least} to ${most} is needed`);
  }
  return wide ? BigInt(value) : Number(value);
}

/** The module's memory, and calls into it. */
class Memory {
  view;
  #exports;
  #host;

  constructor(host, exports) {
    this.#host = host;
    this.#exports = exports;
    host.onMemoryGrowth = () => { this.view = new DataView(exports.memory.buffer); };
    host.onMemoryGrowth();
  }

  /** Calls a function of the library; its error becomes an exception. */
  call(name, ...values) {
    const code = this.#exports[name](...values);
    if (code !== abi.HRT_OK) this.fail(code);
  }
  fail(code) {
    throw new HapticRetargetingError(code, readText(this.view.buffer, this.#exports.hrt_last_error()));
  }
  /** The function itself, for calls every frame. */
  entry(name) { return this.#exports[name]; }

  allocate(size) {
    const at = this.#exports.malloc(size);
    if (at === 0) throw new HapticRetargetingError(abi.HRT_ERROR_OUT_OF_MEMORY, `out of memory: ${size} bytes`);
    new Uint8Array(this.view.buffer, at, size).fill(0);
    return at;
  }
  free(at) { this.#exports.free(at); }

  /** Lends memory to `use` while it runs. */
  with(size, use) {
    const at = this.allocate(size);
    try {
      return use(at);
    } finally {
      this.free(at);
    }
  }
  withBytes(bytes, use) {
    return this.with(bytes.length + 1, (at) => {
      new Uint8Array(this.view.buffer, at, bytes.length).set(bytes);
      return use(at, BigInt(bytes.length));
    });
  }
  withText(text, use) { return this.withBytes(encoder.encode(text), use); }

  /** Lends a struct with its size in place and, if the library has them, its defaults, and `values` over these. */
  withStruct(type, values, use) {
    const { size, fields } = abi.structs[type];
    return this.with(size, (at) => {
      if (this.#exports[`${type}_default`]) this.call(`${type}_default`, at, size);
      else if (fields.struct_size) this.view.setUint32(at, size, true);
      for (const [name, value] of Object.entries(values)) {
        if (value !== undefined) this.write(type, at, name, value);
      }
      return use(at);
    });
  }
  /** What `call` makes of a struct. */
  output(type, call) {
    return this.withStruct(type, {}, (at) => {
      call(at);
      return this.read(type, at);
    });
  }

  write(type, at, name, value) {
    const field = Object.hasOwn(abi.structs[type].fields, name) ? abi.structs[type].fields[name] : undefined;
    if (!field || name === "struct_size") {
      throw new TypeError(`${type} has no field ${name}; it has ${fieldNames(type).join(", ")}`);
    }
    const offset = at + field.offset;
    if (field.type === "u8") return this.#writeName(name, offset, field.length, value);
    if (abi.structs[field.type]) {
      for (const [inner, part] of Object.entries(value)) this.write(field.type, offset, inner, part);
      return undefined;
    }
    const { size, set } = types[field.type];
    if (!field.length) return this.view[set](offset, checked(name, field.type, value), true);
    if (value?.length !== field.length) throw new TypeError(`${name} is not an array of ${field.length} numbers`);
    for (let i = 0; i < field.length; ++i) {
      this.view[set](offset + size * i, checked(`${name}[${i}]`, field.type, value[i]), true);
    }
    return undefined;
  }
  #writeName(name, offset, capacity, value) {
    const bytes = encoder.encode(value);
    if (bytes.length >= capacity) {
      throw new RangeError(`${name} is "${value}", ${bytes.length} bytes in UTF-8; up to ${capacity - 1} are allowed`);
    }
    const place = new Uint8Array(this.view.buffer, offset, capacity);
    place.fill(0);
    place.set(bytes);
  }

  read(type, at) {
    const object = {};
    for (const name of fieldNames(type)) object[name] = this.#readField(abi.structs[type].fields[name], at);
    return object;
  }
  #readField(field, at) {
    const offset = at + field.offset;
    if (field.type === "u8") return readText(this.view.buffer.slice(offset, offset + field.length), 0);
    if (abi.structs[field.type]) return this.read(field.type, offset);
    const { size, get } = types[field.type];
    if (!field.length) return this.view[get](offset, true);
    return Array.from({ length: field.length }, (_, i) => this.view[get](offset + size * i, true));
  }

  /** Takes a recording's text out of the files. */
  takeFile(path) {
    const file = this.#host.files.get(path);
    this.#host.files.delete(path);
    return file.parts.map((part) => decoder.decode(part)).join("");
  }
}

function fieldNames(type) {
  return Object.keys(abi.structs[type].fields).filter((name) => name !== "struct_size" && name !== "reserved");
}

// A struct that stays where it is, with an accessor for each field. Reading and writing make no objects: 64-bit
// integers are numbers, which are exact to 2^53; arrays are views of memory, made anew only when it has grown.
function defineView(type) {
  class View {
    #memory;
    #at;
    constructor(memory) {
      this.#memory = memory;
      this.#at = memory.allocate(abi.structs[type].size);
      memory.view.setUint32(this.#at, abi.structs[type].size, true);
    }
    get address() { return this.#at; }
    free() { this.#memory.free(this.#at); }

    static {
      for (const name of fieldNames(type)) {
        const { offset, type: element, length } = abi.structs[type].fields[name];
        Object.defineProperty(View.prototype, name, length ? array(offset, length) : accessors[element](name, offset));
      }

      function array(offset, length) {
        const cached = new WeakMap();
        return { enumerable: true, get() {
          let values = cached.get(this);
          if (values?.buffer !== this.#memory.view.buffer) {
            values = new Float64Array(this.#memory.view.buffer, this.#at + offset, length);
            cached.set(this, values);
          }
          return values;
        } };
      }
    }
    static memoryOf(view) { return view.#memory; }
  }
  return View;
}

const accessors = {
  f64: (name, offset) => ({
    enumerable: true,
    get() { return viewOf(this).getFloat64(this.address + offset, true); },
    set(value) { viewOf(this).setFloat64(this.address + offset, value, true); },
  }),
  u32: (name, offset) => ({
    enumerable: true,
    get() { return viewOf(this).getUint32(this.address + offset, true); },
    set(value) {
      if (value >>> 0 !== value) throw new RangeError(`${name} is ${value}; a whole number from 0 is needed`);
      viewOf(this).setUint32(this.address + offset, value, true);
    },
  }),
  i64: (name, offset) => ({
    enumerable: true,
    get() {
      const view = viewOf(this), at = this.address + offset;
      return view.getInt32(at + 4, true) * 2 ** 32 + view.getUint32(at, true);
    },
    set(value) {
      const rounded = Math.round(value);
      if (!Number.isSafeInteger(rounded)) throw new RangeError(`${name} is ${value}; up to 2^53 is allowed`);
      const view = viewOf(this), at = this.address + offset, high = Math.floor(rounded / 2 ** 32);
      view.setInt32(at + 4, high, true);
      view.setUint32(at, rounded - high * 2 ** 32, true);
    },
  }),
};

function viewOf(struct) { return struct.constructor.memoryOf(struct).view; }

const SampleView = defineView("hrt_sample"), CommandView = defineView("hrt_command");

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
  loadScene(bytes, name = "scene") { return new Scene(this.#memory, bytes, name); }

  replay(text) {
    return this.#memory.withText(text, (at, length) =>
      this.#memory.output("hrt_replay_report", (out) => this.#memory.call("hrt_replay_text", at, length, out)));
  }
}

// Handles and ids come as a struct of one u64.
function created(memory, create) {
  return memory.with(8, (at) => {
    create(at);
    return memory.view.getBigUint64(at, true);
  });
}

class Session {
  static #count = 0;
  #memory;
  #handle;
  #update;
  #path;

  constructor(memory, config) {
    this.#memory = memory;
    this.#handle = memory.withStruct("hrt_session_config", config, (at) =>
      created(memory, (out) => memory.call("hrt_session_create", at, out)));
    this.#update = memory.entry("hrt_reach_update");
    this.#path = `recording ${++Session.#count}`;
    this.sample = new SampleView(memory);
    this.command = new CommandView(memory);
  }

  get handle() { return this.#handle; }

  destroy() {
    this.#memory.call("hrt_session_destroy", this.#handle);
    this.sample.free();
    this.command.free();
  }

  get config() {
    return this.#memory.output("hrt_session_config", (at) =>
      this.#memory.call("hrt_session_get_config", this.#handle, at));
  }
  configure(changes) {
    this.#memory.withStruct("hrt_session_config", { ...this.config, ...changes }, (at) =>
      this.#memory.call("hrt_session_set_config", this.#handle, at));
  }

  addTarget(config) {
    return this.#memory.withStruct("hrt_target_config", config, (at) =>
      created(this.#memory, (out) => this.#memory.call("hrt_target_add", this.#handle, at, out)));
  }
  target(id) {
    return this.#memory.output("hrt_target_config", (at) =>
      this.#memory.call("hrt_target_get", this.#handle, id, at));
  }
  setTarget(id, changes) {
    this.#memory.withStruct("hrt_target_config", { ...this.target(id), ...changes }, (at) =>
      this.#memory.call("hrt_target_set", this.#handle, id, at));
  }
  removeTarget(id) { this.#memory.call("hrt_target_remove", this.#handle, id); }
  findTarget(name) {
    return this.#memory.withText(name, (at) =>
      created(this.#memory, (out) => this.#memory.call("hrt_target_find", this.#handle, at, out)));
  }
  targets(role = 0) {
    const memory = this.#memory;
    return memory.with(8, (count) => {
      memory.call("hrt_target_list", this.#handle, role, 0n, 0, count);
      const capacity = memory.view.getBigUint64(count, true);
      return memory.with(8 * Number(capacity) + 1, (ids) => {
        memory.call("hrt_target_list", this.#handle, role, capacity, ids, count);
        return Array.from({ length: Number(capacity) }, (_, i) => memory.view.getBigUint64(ids + 8 * i, true));
      });
    });
  }

  authority(realTarget, virtualTarget) {
    return this.#memory.output("hrt_authority", (at) =>
      this.#memory.call("hrt_authority_query", this.#handle, realTarget, virtualTarget, at));
  }
  bestAuthority(virtualTarget) {
    return this.#memory.output("hrt_authority", (at) =>
      this.#memory.call("hrt_authority_query_best", this.#handle, virtualTarget, at));
  }

  assign(virtualTargets, realTargets, exclusive = false) {
    const memory = this.#memory, count = virtualTargets.length, { size } = abi.structs.hrt_authority;
    const ids = [...virtualTargets, ...realTargets];
    return memory.with(8 * ids.length + 1, (at) => memory.with(size * count + 4, (out) => {
      ids.forEach((id, i) => memory.view.setBigUint64(at + 8 * i, id, true));
      memory.view.setUint32(out, size, true);
      memory.call("hrt_target_assign", this.#handle, at, BigInt(count), at + 8 * count, BigInt(realTargets.length),
        exclusive ? abi.HRT_ASSIGN_EXCLUSIVE : 0, BigInt(count), out);
      return Array.from({ length: count }, (_, i) => memory.read("hrt_authority", out + size * i));
    }));
  }

  get state() {
    return this.#memory.with(4, (at) => {
      this.#memory.call("hrt_session_get_state", this.#handle, at);
      return this.#memory.view.getUint32(at, true);
    });
  }

  beginReach(realTarget, virtualTarget, plateOrientationDeg, startAtFinger = false) {
    const flags = (plateOrientationDeg === undefined ? 0 : abi.HRT_REACH_PLATE_ORIENTATION) |
                  (startAtFinger ? abi.HRT_REACH_START_AT_FINGER : 0);
    this.#memory.withStruct("hrt_reach_config", { real_target: realTarget, virtual_target: virtualTarget, flags,
                                                  plate_orientation_deg: plateOrientationDeg },
      (at) => this.#memory.call("hrt_reach_begin", this.#handle, at));
  }
  retargetReach(realTarget, virtualTarget) {
    this.#memory.call("hrt_reach_retarget", this.#handle, realTarget, virtualTarget);
  }
  cancelReach() { this.#memory.call("hrt_reach_cancel", this.#handle); }
  update() {
    const code = this.#update(this.#handle, this.sample.address, this.command.address);
    if (code !== abi.HRT_OK) this.#memory.fail(code);
  }
  endReach() {
    return this.#memory.output("hrt_reach_summary", (at) =>
      this.#memory.call("hrt_reach_end", this.#handle, at));
  }

  get profile() {
    const memory = this.#memory;
    return memory.with(8, (length) => {
      memory.call("hrt_profile_save", this.#handle, 0n, 0, length);
      const capacity = memory.view.getBigUint64(length, true) + 1n;
      return memory.with(Number(capacity), (text) => {
        memory.call("hrt_profile_save", this.#handle, capacity, text, length);
        return readText(memory.view.buffer, text);
      });
    });
  }
  loadProfile(text) {
    this.#memory.withText(text, (at, length) => this.#memory.call("hrt_profile_load", this.#handle, at, length));
  }

  createCalibration(config = {}) { return new Calibration(this.#memory, this.#handle, config); }
  applyCalibration(result) {
    this.#memory.withStruct("hrt_calibration_result", result, (at) =>
      this.#memory.call("hrt_calibration_apply", this.#handle, at));
  }

  startRecording() {
    this.#memory.withText(this.#path, (at) => this.#memory.call("hrt_recording_start", this.#handle, at));
  }
  stopRecording() {
    this.#memory.output("hrt_recording_status", (at) =>
      this.#memory.call("hrt_recording_stop", this.#handle, at));
    return this.#memory.takeFile(this.#path);
  }
}

class Calibration {
  #memory;
  #handle;

  constructor(memory, session, config) {
    this.#memory = memory;
    this.#handle = memory.withStruct("hrt_calibration_config", config, (at) =>
      created(memory, (out) => memory.call("hrt_calibration_create", session, at, out)));
    this.sample = new SampleView(memory);
  }

  destroy() {
    this.#memory.call("hrt_calibration_destroy", this.#handle);
    this.sample.free();
  }

  beginTrial(plateOrientationDeg) {
    this.#memory.call("hrt_calibration_begin_trial", this.#handle,
      checked("plateOrientationDeg", "f64", plateOrientationDeg));
  }
  addSample() { this.#memory.call("hrt_calibration_add_sample", this.#handle, this.sample.address); }
  endTrial() { this.#memory.call("hrt_calibration_end_trial", this.#handle); }
  cancelTrial() { this.#memory.call("hrt_calibration_cancel_trial", this.#handle); }
  solve() {
    return this.#memory.output("hrt_calibration_result", (at) =>
      this.#memory.call("hrt_calibration_solve", this.#handle, at));
  }
}

class Scene {
  #memory;
  #handle;

  constructor(memory, bytes, name) {
    this.#memory = memory;
    this.#handle = memory.withText(name, (text) => memory.withBytes(new Uint8Array(bytes), (at, length) =>
      created(memory, (out) => memory.call("hrt_scene_load_memory", at, length, text, out))));
  }

  destroy() { this.#memory.call("hrt_scene_destroy", this.#handle); }

  get info() {
    return this.#memory.output("hrt_scene_info", (at) => this.#memory.call("hrt_scene_get_info", this.#handle, at));
  }
  get targets() {
    return Array.from({ length: this.info.target_count }, (_, i) =>
      this.#memory.output("hrt_scene_target", (at) =>
        this.#memory.call("hrt_scene_get_target", this.#handle, i, at)));
  }
  register(session) {
    const memory = this.#memory, count = this.info.target_count;
    return memory.with(8 * count + 1, (ids) => {
      memory.call("hrt_scene_register", this.#handle, session.handle, BigInt(count), ids);
      return Array.from({ length: count }, (_, i) => memory.view.getBigUint64(ids + 8 * i, true));
    });
  }
}

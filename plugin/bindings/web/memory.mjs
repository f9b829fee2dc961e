// The module's memory, calls into the module, and the system functions that it imports.
import * as abi from "./abi.js";
import { checked, types } from "./numbers.mjs";

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

const encoder = new TextEncoder(), decoder = new TextDecoder();

export function readText(buffer, at) {
  const bytes = new Uint8Array(buffer, at);
  return decoder.decode(bytes.subarray(0, bytes.indexOf(0)));
}

export class Memory {
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
  /** Returns an exported function, so that calls in each frame need not look it up. */
  entry(name) { return this.#exports[name]; }

  allocate(size) {
    const at = this.#exports.malloc(size);
    if (at === 0) throw new HapticRetargetingError(abi.HRT_ERROR_OUT_OF_MEMORY, `out of memory: ${size} bytes cannot be allocated; destroy objects that are not used`);
    new Uint8Array(this.view.buffer, at, size).fill(0);
    return at;
  }
  allocateStruct(type) {
    const at = this.allocate(abi.structs[type].size);
    this.view.setUint32(at, abi.structs[type].size, true);
    return at;
  }
  free(at) { this.#exports.free(at); }

  /** Calls `use` with the address of zeroed memory, which is freed afterwards. Returns the result of `use`. */
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

  /** Calls `use` with the address of a struct that contains its size and its fields: `values`, or else the defaults. */
  withStruct(type, values, use) {
    const { size, fields, defaults } = abi.structs[type];
    return this.with(size, (at) => {
      if (fields.struct_size) this.view.setUint32(at, size, true);
      for (const [name, value] of Object.entries({ ...defaults, ...values })) {
        if (value !== undefined) this.write(type, at, name, value);
      }
      return use(at);
    });
  }
  /** Returns the struct that `call` writes at the address that it receives. */
  output(type, call) {
    return this.withStruct(type, {}, (at) => {
      call(at);
      return this.read(type, at);
    });
  }

  /** Returns the struct that a function writes to its last argument. */
  get(type, name, ...values) { return this.output(type, (at) => this.call(name, ...values, at)); }
  put(type, fields, name, ...values) { this.withStruct(type, fields, (at) => this.call(name, ...values, at)); }

  write(type, at, name, value) {
    const field = Object.hasOwn(abi.structs[type].fields, name) ? abi.structs[type].fields[name] : undefined;
    if (!field || name === "struct_size") {
      throw new TypeError(`${type} has no field ${name}; it has ${fieldNames(type).join(", ")}`);
    }
    const offset = at + field.offset;
    if (field.type === "u8") return this.#writeName(name, offset, field.length, value);
    if (abi.structs[field.type]) {
      if (typeof value !== "object" || value === null) throw new TypeError(`${name} is ${String(value)}; an object is needed`);
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
    if (typeof value !== "string") throw new TypeError(`${name} is ${String(value)}; a string is needed`);
    const bytes = encoder.encode(value);
    if (bytes.length >= capacity) {
      throw new RangeError(`${name} is "${value}", which has ${bytes.length} bytes in UTF-8; allowed: up to ${capacity - 1}`);
    }
    const place = new Uint8Array(this.view.buffer, offset, capacity);
    place.fill(0);
    place.set(bytes);
  }

  read(type, at) {
    const object = Object.defineProperty({}, "toJSON", { value: jsonOf });  // not enumerable, so that loops and copies skip it
    for (const name of fieldNames(type)) object[name] = this.#readField(abi.structs[type].fields[name], at);
    return object;
  }
  #readField(field, at) {
    const offset = at + field.offset;
    if (field.type === "u8") return readText(this.view.buffer.slice(offset, offset + field.length), 0);
    if (abi.structs[field.type]) return this.read(field.type, offset);
    const { size, get } = types[field.type];
    if (field.type === "id") return Number(this.view[get](offset, true));
    if (!field.length) return this.view[get](offset, true);
    return Array.from({ length: field.length }, (_, i) => this.view[get](offset + size * i, true));
  }

  /** Returns the text of a recording and removes its file. */
  takeFile(path) {
    const file = this.#host.files.get(path);
    this.#host.files.delete(path);
    return file.parts.map((part) => decoder.decode(part)).join("");
  }
}

// JSON has no 64-bit integers: they become numbers if that is exact, and decimal text otherwise.
function jsonOf() {
  return Object.fromEntries(Object.entries(this).map(([name, value]) => [name,
    typeof value !== "bigint" ? value : Number.isSafeInteger(Number(value)) ? Number(value)
      : String(value)]));
}

function fieldNames(type) {
  return Object.keys(abi.structs[type].fields).filter((name) => name !== "struct_size" && name !== "reserved");
}

// Functions that the module imports: log, clock, and files, which are kept in memory.
const EBADF = 8, ENOENT = 44;

export class Host {
  files = new Map();  // written content by path
  #open = new Map();  // written content by descriptor
  #nextDescriptor = 3;
  #memory;
  onMemoryGrowth = () => {};

  imports() {
    const refuse = () => EBADF;
    return {
      env: {
        emscripten_notify_memory_growth: () => this.onMemoryGrowth(),
        hrt_web_log: (context, level, text) => console.warn(`haptic-retargeting: ${readText(this.#memory.buffer, text)}`),
        hrt_web_open: (path, writes) => this.#openFile(path, writes),
      },
      wasi_snapshot_preview1: {
        fd_write: (fd, parts, count, written) => this.#write(fd, parts, count, written),
        fd_close: (fd) => (this.#open.delete(fd) ? 0 : EBADF),
        fd_read: refuse,
        fd_seek: refuse,
        fd_fdstat_get: refuse,
        clock_time_get: (id, precision, at) => this.#time(at),
        environ_sizes_get: (count, size) => this.#zero(count, size),
        environ_get: () => 0,
        proc_exit: (code) => { throw new Error(`the module ended with exit code ${code}; load the module again`); },
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

  /** Writes the nanoseconds of a monotonic clock. */
  #time(at) {
    new DataView(this.#memory.buffer).setBigUint64(at, BigInt(Math.round(1e6 * performance.now())), true);
    return 0;
  }
  #zero(...pointers) {
    const view = new DataView(this.#memory.buffer);
    for (const pointer of pointers) view.setUint32(pointer, 0, true);
    return 0;
  }
}

// Checks numbers, and reads and writes them in the module's memory.

// Size and DataView methods of each type of number. Integers are allowed from `least` to `most`.
export const types = {
  u32: { size: 4, least: 0, most: 2 ** 32 - 1, get: "getUint32", set: "setUint32" },
  i32: { size: 4, least: -(2 ** 31), most: 2 ** 31 - 1, get: "getInt32", set: "setInt32" },
  u64: { size: 8, least: 0n, most: 2n ** 64n - 1n, get: "getBigUint64", set: "setBigUint64" },
  i64: { size: 8, least: -(2n ** 63n), most: 2n ** 63n - 1n, get: "getBigInt64", set: "setBigInt64" },
  id: { size: 8, least: 0n, most: BigInt(Number.MAX_SAFE_INTEGER), get: "getBigUint64", set: "setBigUint64" },  // id of a target
  f64: { size: 8, get: "getFloat64", set: "setFloat64" },
};

// Checks and converts a value. The library checks the range that is allowed for a field.
export function checked(name, type, value) {
  const { least, most } = types[type];
  if (type === "f64") {
    if (typeof value !== "number") throw new TypeError(`${name} is ${String(value)}; a number is needed`);
    return value;
  }
  const wide = typeof least === "bigint";
  const whole = typeof value === "bigint" || Number.isSafeInteger(value);
  if (!whole || value < least || value > most) {
    const needed = type === "id" ? "the id of a target, as addTarget() returns it," : `a whole number from ${least} to ${most}${wide ? ", above 2^53 a BigInt," : ""}`;
    throw new RangeError(`${name} is ${String(value)}; ${needed} is needed`);
  }
  return wide ? BigInt(value) : Number(value);
}

// For use in each frame, without new objects: 64-bit integers are numbers, exact to 2^53. Doubles are not checked.
export function writeU32(view, at, name, value) {
  if (value >>> 0 !== value) throw new RangeError(`${name} is ${String(value)}; a whole number from 0 to 4294967295 is needed`);
  view.setUint32(at, value, true);
}
export function writeI64(view, at, name, value) {
  const rounded = Math.round(value);
  if (!Number.isSafeInteger(rounded)) throw new RangeError(`${name} is ${String(value)}; a number between -2^53 and 2^53 is needed`);
  const high = Math.floor(rounded / 2 ** 32);
  view.setInt32(at + 4, high, true);
  view.setUint32(at, rounded - high * 2 ** 32, true);
}
export function readI64(view, at) { return view.getInt32(at + 4, true) * 2 ** 32 + view.getUint32(at, true); }
export function writeF64s(view, at, name, values, length) {
  if (values?.length !== length) throw new TypeError(`${name} is ${String(values)}; an array of ${length} numbers is needed`);
  for (let i = 0; i < length; ++i) view.setFloat64(at + 8 * i, values[i], true);
}

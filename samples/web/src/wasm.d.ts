/** A WebAssembly module's bytes, within the bundle. */
declare module "*.wasm" {
  const bytes: Uint8Array<ArrayBuffer>;
  export default bytes;
}

/** The plate's firmware in Intel's hexadecimal format, within the bundle. */
declare module "plate_firmware.hex" {
  const text: string;
  export default text;
}
declare module "*.csv" {
  const text: string;
  export default text;
}

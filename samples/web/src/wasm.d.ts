/** A WebAssembly module's bytes within the bundle, or its address; below, the same of a model. */
declare module "*.wasm" {
  const module: Uint8Array<ArrayBuffer> | string;
  export default module;
}

/** The plate's firmware in Intel's hexadecimal format, within the bundle. */
declare module "plate_firmware.hex" {
  const text: string;
  export default text;
}
declare module "*.glb" {
  const model: Uint8Array<ArrayBuffer> | string;
  export default model;
}
declare module "*.csv" {
  const text: string;
  export default text;
}

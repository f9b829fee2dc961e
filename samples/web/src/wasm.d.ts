/** Bytes of a WebAssembly module within the bundle, or its address; the next declaration is the same for a model. */
declare module "*.wasm" {
  const module: Uint8Array<ArrayBuffer> | string;
  export default module;
}

/** Firmware of the plate in Intel's hexadecimal format, within the bundle. */
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

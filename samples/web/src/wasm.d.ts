/** Content of a file in the bundle, or the address of the file. */
declare module "*.wasm" {
  const module: Uint8Array<ArrayBuffer> | string;
  export default module;
}

declare module "*.glb" {
  const model: Uint8Array<ArrayBuffer> | string;
  export default model;
}
declare module "*.csv" {
  const text: string;
  export default text;
}

// A .wasm or .glb file is imported as its content in offline.js, and as its address in page.js.
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

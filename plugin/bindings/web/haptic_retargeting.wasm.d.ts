/** The module as the bundler imports it, to be passed to load(): its address, its bytes, or the module. */
declare const wasm: string | URL | WebAssembly.Module | ArrayBuffer | ArrayBufferView;
export default wasm;

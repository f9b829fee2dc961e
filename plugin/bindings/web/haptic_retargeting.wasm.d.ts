/** The module in the form in which a bundler passes it to load(): its address, its bytes, or the module. */
declare const wasm: string | URL | WebAssembly.Module | ArrayBuffer | ArrayBufferView;
export default wasm;

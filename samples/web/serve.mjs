// Serves the page on this machine.
//   usage: node serve.mjs FOLDER_OF_THE_PAGE [PORT]    default port: 8737
import { readdir, readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";
import { brotliCompressSync, constants, gzipSync } from "node:zlib";

const [, , folder, port = "8737"] = process.argv;
if (!/^\d{1,5}$/.test(port) || Number(port) > 65535) {
  console.error(`serve.mjs: port "${port}"; a whole number from 0 (any free one) to 65535 is needed`);
  process.exit(2);
}

// Serves only the files of the page's folder, compressed, as any server of static files does.
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8",
                ".txt": "text/plain; charset=utf-8", ".wasm": "application/wasm", ".glb": "model/gltf-binary", ".gif": "image/gif" };
const names = new Set((await readdir(folder)).filter((name) => types[extname(name)]));
const encoders = {
  br: (bytes) => brotliCompressSync(bytes, { params: { [constants.BROTLI_PARAM_QUALITY]: 5 } }),
  gzip: (bytes) => gzipSync(bytes, { level: 9 }),
};
const encoded = new Map();

async function read(name, encoding) {
  const key = `${encoding} ${name}`;
  if (!encoded.has(key)) encoded.set(key, encoders[encoding](await readFile(join(folder, name))));
  return encoded.get(key);
}

const server = createServer(async (request, response) => {
  const { pathname } = new URL(request.url, "http://localhost");
  const name = pathname === "/" ? "index.html" : pathname.slice(1);
  if (!names.has(name)) return response.writeHead(404).end();
  const headers = { "content-type": types[extname(name)], "cache-control": "no-store", "x-content-type-options": "nosniff" };
  try {
    const accepted = request.headers["accept-encoding"] ?? "",
      encoding = Object.keys(encoders).find((each) => new RegExp(`\\b${each}\\b`).test(accepted));
    if (encoding) response.writeHead(200, { ...headers, "content-encoding": encoding }).end(await read(name, encoding));
    else response.writeHead(200, headers).end(await readFile(join(folder, name)));
  } catch (error) {
    response.writeHead(500).end(`${name}: ${error.code}`);
  }
});
server.on("error", (error) => {
  console.error(`serve.mjs: port ${port}: ${error.message}`);
  process.exit(1);
});
server.listen(Number(port), "127.0.0.1", () => console.log(`Open http://127.0.0.1:${server.address().port}/ (Ctrl-C stops)`));

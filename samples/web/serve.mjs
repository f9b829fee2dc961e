// Serves the page on this machine.
//   usage: node serve.mjs FOLDER_OF_THE_PAGE PORT    port 0: any free port
import { readdir, readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { extname, join } from "node:path";

const [, , folder, port] = process.argv;

// Files of other types are not served. A browser that accepts Brotli receives the compressed copy, if there is one.
const types = { ".html": "text/html; charset=utf-8", ".js": "text/javascript; charset=utf-8", ".css": "text/css; charset=utf-8",
                ".txt": "text/plain; charset=utf-8", ".wasm": "application/wasm", ".glb": "model/gltf-binary", ".gif": "image/gif" };
const names = new Set(await readdir(folder));

const server = createServer(async (request, response) => {
  const { pathname } = new URL(request.url, "http://localhost");
  const name = pathname === "/" ? "index.html" : pathname.slice(1);
  if (!names.has(name) || !types[extname(name)]) return response.writeHead(404).end();
  const headers = { "content-type": types[extname(name)], "cache-control": "no-store", "x-content-type-options": "nosniff" };
  try {
    const compressed = names.has(`${name}.br`) && /\bbr\b/.test(request.headers["accept-encoding"]);
    if (compressed) headers["content-encoding"] = "br";
    response.writeHead(200, headers).end(await readFile(join(folder, compressed ? `${name}.br` : name)));
  } catch (error) {
    response.writeHead(500).end(`${name}: ${error.code}`);
  }
});
server.on("error", (error) => {
  console.error(`serve.mjs: port ${port}: ${error.message}; use another port, or 0 for any free one`);
  process.exit(1);
});
server.listen(Number(port), "127.0.0.1", () => console.log(`Open http://127.0.0.1:${server.address().port}/ (Ctrl-C stops)`));

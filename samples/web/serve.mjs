// Serves the page on this machine.
//   usage: node serve.mjs FOLDER_OF_THE_PAGE [PORT]    default port: 8737
import { readFile } from "node:fs/promises";
import { createServer } from "node:http";
import { join } from "node:path";

const [, , folder, port = "8737"] = process.argv;
if (!/^\d{1,5}$/.test(port) || Number(port) > 65535) {
  console.error(`serve.mjs: port "${port}"; a whole number from 0 (any free one) to 65535 is needed`);
  process.exit(2);
}

// All that the page consists of; other paths are not there.
const types = { "index.html": "text/html; charset=utf-8", "page.js": "text/javascript; charset=utf-8",
                "page.css": "text/css; charset=utf-8", "licences.txt": "text/plain; charset=utf-8" };

const server = createServer(async (request, response) => {
  const { pathname } = new URL(request.url, "http://localhost");
  const name = pathname === "/" ? "index.html" : pathname.slice(1);
  if (!Object.hasOwn(types, name)) return response.writeHead(404).end();
  try {
    const bytes = await readFile(join(folder, name));
    response.writeHead(200, { "content-type": types[name], "cache-control": "no-store",
                              "x-content-type-options": "nosniff" }).end(bytes);
  } catch (error) {
    response.writeHead(500).end(`${name}: ${error.code}`);
  }
});
server.on("error", (error) => {
  console.error(`serve.mjs: port ${port}: ${error.message}`);
  process.exit(1);
});
server.listen(Number(port), "127.0.0.1", () => console.log(`Open http://127.0.0.1:${server.address().port}/ (Ctrl-C stops)`));

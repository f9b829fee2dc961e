// From a server, page.js is loaded, and the parts that its first picture needs are preloaded. At a file: address
// browsers load no parts, so offline.js contains the whole page. build.mjs inserts the names of the parts.
const served = location.protocol !== "file:";
for (const href of served ? [/* parts */] : []) {
  const link = document.createElement("link"), script = href.endsWith(".js");
  Object.assign(link, script ? { rel: "modulepreload" } : { rel: "preload", as: "fetch", crossOrigin: "anonymous" }, { href });
  document.head.append(link);
}
addEventListener("DOMContentLoaded", () => {
  if (served) return import("./page.js");
  const whole = document.createElement("script");
  whole.src = "offline.js";
  document.head.append(whole);
});

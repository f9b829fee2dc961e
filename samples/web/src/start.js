// Loads the page, and preloads the parts of its first picture, whose names build.mjs inserts. At a file: address, where
// browsers load no parts, offline.js contains the whole page.
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

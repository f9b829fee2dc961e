// A server gives the page in parts; a file: address, from which no part can be loaded, gives it whole.
if (location.protocol === "file:") {
  const whole = document.createElement("script");
  whole.src = "offline.js";
  document.head.append(whole);
} else {
  import("./page.js");
}

// Bundles the emulated headset (headset.ts) as a script for a page.
import { dirname, join } from "node:path";
import { fileURLToPath } from "node:url";
import { require, sources } from "./browser.mjs";

const { outputFiles: [{ text }] } = await require("esbuild").build({
  entryPoints: [join(dirname(fileURLToPath(import.meta.url)), "headset.ts")], bundle: true, write: false, format: "iife",
  target: "es2022", tsconfigRaw: {}, nodePaths: [join(sources, "node_modules")], logLevel: "warning",
});
export const headset = text;

/** Optional properties of WebXR frames, joint poses and sessions, which only some browsers have. */
export const optional = ["predictedDisplayTime", "fillPoses", "fillJointRadii", "radius", "enabledFeatures", "frameRate", "supportedFrameRates",
                         "updateTargetFrameRate"];

/** Returns a script that emulates the headset, in a browser without the properties `lacking`. */
export const without = (lacking) => `${headset};(${(names) => {
  const mask = (object) => {
    for (const name of names) if (object && name in object) Object.defineProperty(object, name, { value: undefined, configurable: true });
    return object;
  };
  const { requestAnimationFrame } = XRSession.prototype, { getJointPose } = XRFrame.prototype, { requestSession } = navigator.xr;
  XRSession.prototype.requestAnimationFrame = function (use) {
    return requestAnimationFrame.call(this, (time, frame) => use(time, mask(frame)));
  };
  XRFrame.prototype.getJointPose = function (...of) { return mask(getJointPose.apply(this, of)); };
  navigator.xr.requestSession = async (...wanted) => mask(await requestSession.apply(navigator.xr, wanted));
}})(${JSON.stringify(lacking)});`;

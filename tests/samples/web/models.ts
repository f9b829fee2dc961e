// The modules of the page that models_test.mjs tests: those that need no browser.
export { load } from "haptic-retargeting";
export * as hrt from "haptic-retargeting";
export { HandReach, HapticPlate } from "haptic-retargeting/three";
export { Scene, Vector3 } from "three";
export { default as pluginModule } from "haptic-retargeting/haptic_retargeting.wasm";
export * from "../../../samples/web/src/geometry";
export * from "../../../samples/web/src/settings";
export { createWorld } from "../../../samples/web/src/person";
export { VisitorReach } from "../../../samples/web/src/visitor_reach";
export * from "../../../samples/web/src/plate/line";
export { PlateLink } from "../../../samples/web/src/plate/link";
export { openPort } from "../../../samples/web/src/plate/serial";
export { wrapped } from "../../../samples/web/src/stage/headset";
export { RestDetector } from "../../../samples/web/src/wear/rest_detector";
export { Placement } from "../../../samples/web/src/wear/placement";
export { HeadsetReach } from "../../../samples/web/src/wear/headset_reach";
export { SimulatedReach } from "../../../samples/web/src/simulated_reach";
export { pageCourse } from "../../../samples/web/src/controller";

// What models_test.mjs tests of the page: everything that needs no browser.
export { load } from "haptic-retargeting";
export * as hrt from "haptic-retargeting";
export { HandReach, HapticPlate } from "haptic-retargeting/three";
export { Scene, Vector3 } from "three";
export { default as pluginModule } from "haptic-retargeting/haptic_retargeting.wasm";
export * from "../../../samples/web/src/geometry";
export * from "../../../samples/web/src/settings";
export { createWorld } from "../../../samples/web/src/person";
export { Hand } from "../../../samples/web/src/hand";
export { Board } from "../../../samples/web/src/plate/board";
export * from "../../../samples/web/src/plate/line";
export { PlateLink } from "../../../samples/web/src/plate/link";
export { openPort } from "../../../samples/web/src/plate/serial";
export { Rest } from "../../../samples/web/src/wear/rest";
export { Placing } from "../../../samples/web/src/wear/placing";
export { default as firmware } from "plate_firmware.hex";
export { Watch } from "../../../samples/web/src/watch";
export { pageCourse } from "../../../samples/web/src/controller";

// The modules that are tested under node: those that need no browser.
export { load } from "haptic-retargeting";
export * as hrt from "haptic-retargeting";
export { default as pluginModule } from "haptic-retargeting/haptic_retargeting.wasm";
export { HandReach, HapticPlate } from "haptic-retargeting/three";
export { Vector3 } from "three";
export * from "../../../samples/web/src/geometry";
export { QuestPlus } from "../../../samples/web/src/modes/series";
export * from "../../../samples/web/src/plate/link";
export { PlateDevice } from "../../../samples/web/src/plate/plate_panel";
export { SimulatedReach } from "../../../samples/web/src/simulated_reach";
export { wrapped } from "../../../samples/web/src/stage/headset";
export { VisitorReach } from "../../../samples/web/src/visitor_reach";
export { HeadsetReach } from "../../../samples/web/src/wear/headset_reach";

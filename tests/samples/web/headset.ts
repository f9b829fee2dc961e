// An emulated headset with tracked hands (iwer) for the page. Tests move the hand by its fingertip.
import { metaQuest3, P_SPACE, XRDevice } from "iwer";

const device = new XRDevice(metaQuest3);
device.installRuntime({ forceInstall: true });
device.primaryInputMode = "hand";
device.hands.left.connected = false;
const hand = device.hands.right;
device.quaternion.set(-0.34, 0, 0, 0.94);  // the headset looks down by 40 degrees
hand.poseId = "point";
hand.updateHandPose();

const spaces: EventTarget[] = [], { requestReferenceSpace } = XRSession.prototype;
XRSession.prototype.requestReferenceSpace = async function (...kind) {
  const space = await requestReferenceSpace.apply(this, kind);
  spaces.push(space);
  return space;
};

globalThis.headset = {
  device,
  /** Moves the index fingertip to a position in the emulated room. */
  moveTip(x, y, z) {
    const at = hand.inputSource.hand.get("index-finger-tip")[P_SPACE].offsetMatrix;
    hand.position.set(x - at[12], y - at[13], z - at[14]);
  },
  /** Draws a frame, and lets the double of a plate's serial line answer (plate_double.mjs). */
  async frame(elapsed_ms) {
    globalThis.drawFrame(elapsed_ms);
    for (let i = 0; i < 50; ++i) await null;
  },
  pinch(touch: boolean) { hand.updatePinchValue(touch ? 1 : 0); hand.poseId = touch ? "pinch" : "point"; hand.updateHandPose(); },
  /** Moves the other hand to a position, where it rests. */
  restOther(x, y, z) {
    const left = device.hands.left;
    left.connected = true;
    left.position.set(x, y, z);
  },
  see(seen) { hand.connected = seen; },
  /** Reports that the headset was recentred. The emulated room does not move. */
  recentre() { for (const space of spaces) space.dispatchEvent(new Event("reset")); },
  leave() { return device.activeSession.end(); },
};

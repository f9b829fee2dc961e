// Reaches of a hand that a headset tracks: places the plate, waits for the hand in the ring, lets the plugin control
// the slide, and reports its end. The caller passes the frames, so that tests need no browser.
import { HRT_COMMAND_ARRIVED, HRT_SESSION_REGISTERED, type Library } from "haptic-retargeting";
import { HandReach, type HapticPlate } from "haptic-retargeting/three";
import { Quaternion, Vector3 } from "three";
import { cylinderRadius_m, length_m, pageCourse, type SlideEnd, slideEnd, start } from "../geometry";
import type { Settings } from "../settings";
import { VisitorHand } from "../visitor_hand";
import { minReach_m } from "../visitor_reach";
import { Placement, RestDetector } from "./placement";

const startRadius_m = 0.015; // around the start, within the plate's plane
const startHeight_m = 0.03;
const startRest_ms = 400;
const lostLimit_ms = 1000; // after a shorter loss the slide continues
const beyond_m = 0.15; // distance from the start at which the slide ends, because it has passed the targets
const pinch_m = 0.025; // between the tips of thumb and index finger
const liftHeight_m = 0.05; // generous, because without a plate nothing supports the finger
const maxFrame_ms = 100;
/** Fields of the session's configuration that contain the registration of the plate. */
const registered = [
  ...(["plate_position_m", "plate_rotation", "plate_covariance", "registration_time_ns", "flags"] as const),
  ...(["contact_correction", "contact_covariance"] as const),
];

export class HeadsetReach extends VisitorHand {
  phase: "placing" | "ready" | "sliding" | "arrived" = "placing";
  result: SlideEnd | null = null;
  /** Instruction to the visitor, or the result of the slide. */
  text = "";
  /** True while the hand of the reach is not tracked. */
  lost = false;
  /** True if a real cylinder is at the drawn position. */
  hasCylinder = false;
  /** Called with the plate's pose, in the reference space of the frames, when it has been placed. */
  onPlaced: (position: Vector3, rotation: Quaternion) => void = () => {};

  readonly #resting = new RestDetector(startRadius_m, startRest_ms);
  #reach: HandReach;
  #placing!: Placement;
  #byMarks = false;
  #why = "";
  #time_ms = NaN;
  #seen_ms = 0;

  /** `plate`: the drawn plate, whose pose in the scene converts tracked positions to plate coordinates. */
  constructor(
    library: Library,
    private readonly plate: HapticPlate,
    settings: Readonly<Settings>,
  ) {
    super(library, settings);
    this.session.configure({ lift_height_m: liftHeight_m });
    this.#reach = new HandReach(this.session, plate);
    this.begin(false);
  }

  /** Begins the placement of the plate, by touches of its marks or by a pinch. `why`: text before the instruction. */
  begin(byMarks: boolean, why = ""): void {
    this.#byMarks = byMarks;
    this.#placing = new Placement(byMarks ? this.session : null);
    this.#time_ms = NaN;
    this.restart();
    this.phase = "placing";
    this.#why = why;
    this.text = why + this.#placing.text;
  }

  /** Applies other settings, with a new session of the plugin that keeps the registration. */
  apply(settings: Readonly<Settings>): void {
    this.settings = { ...settings };
    const { config } = this.session,
      registration = Object.fromEntries(registered.map((name) => [name, config[name]]));
    this.restartSession(pageCourse(settings.gap_deg));
    this.session.configure({ ...registration, lift_height_m: liftHeight_m });
    this.#reach = new HandReach(this.session, this.plate);
    if (this.phase === "placing") this.begin(this.#byMarks);
    else this.restart();
  }

  /** `now_ms`: time of the frame's callback. `hand`: undefined if it is not tracked. */
  frame(now_ms: number, frame: XRFrame, hand: XRHand | undefined, space: XRReferenceSpace): void {
    const elapsed_ms = Math.min(maxFrame_ms, Math.max(0, now_ms - this.#time_ms || 0));
    this.#time_ms = now_ms;
    this.advancePlate(elapsed_ms);
    if (this.phase === "sliding") return this.#slide(frame, hand, space, elapsed_ms);
    const tip = locate("index-finger-tip", frame, hand, space);
    if (this.phase === "placing") return this.#place(frame, hand, tip, space);
    if (this.#resting.update(now_ms, tip && this.#atStart(tip) ? tip : null)) this.#start();
  }

  #place(frame: XRFrame, hand: XRHand | undefined, tip: Vector3 | null, space: XRReferenceSpace): void {
    const { x = 0, y = 0, z = 0, w = 1 } = frame.getViewerPose(space)?.transform.orientation ?? {},
      view = new Quaternion(x, y, z, w),
      forward = new Vector3(0, 0, -1).applyQuaternion(view);
    // If the visitor looks almost straight down, the top of the head points forward.
    if (Math.hypot(forward.x, forward.z) < 0.3) forward.set(0, 1, 0).applyQuaternion(view);
    const thumb = locate("thumb-tip", frame, hand, space),
      pinches = tip !== null && thumb !== null && tip.distanceTo(thumb) < pinch_m;
    const placed = this.#placing.update(this.#time_ms, tip, forward, pinches);
    this.text = this.#why + this.#placing.text;
    if (!placed) return;
    if (!this.#byMarks) this.session.configure({ flags: this.session.config.flags & ~HRT_SESSION_REGISTERED });
    this.onPlaced(this.#placing.position, this.#placing.rotation);
    this.restart();
  }

  /** Cancels a running reach, and waits for the hand in the ring. */
  restart(): void {
    this.rest();
    this.plate.orientation_deg = this.plate_deg;
    this.#resting.reset();
    this.phase = "ready";
    this.result = null;
    this.lost = false;
    this.text = "Rest the tip of your index finger in the ring.";
  }

  #atStart(tip: Vector3): boolean {
    const { x, y, z } = this.plate.worldToLocal(tip.clone());
    return Math.hypot(x - start.right_m, z + start.away_m) < startRadius_m && Math.abs(y) < startHeight_m;
  }

  #start(): void {
    this.restart();
    this.beginReach(this.plate_deg);
    this.#seen_ms = this.#time_ms;
    this.phase = "sliding";
    this.text = "Slide to the orange glass. Stop there.";
  }

  #slide(frame: XRFrame, hand: XRHand | undefined, space: XRReferenceSpace, elapsed_ms: number): void {
    const reach = this.#reach,
      { sample } = this.session;
    reach.measuredPlate_deg = this.plateConnected_deg;
    reach.updateFromHand(this.#time_ms, frame, hand, space);
    this.turnPlate();
    this.plate.orientation_deg = this.plate_deg;
    this.lost = reach.lost;
    if (reach.lost) {
      if (this.#time_ms - this.#seen_ms <= lostLimit_ms) return;
      this.restart();
      this.text = `The headset did not see your hand for a second. ${this.text}`;
      return;
    }
    this.#seen_ms = this.#time_ms;
    const { x, y, z } = this.plate.worldToLocal(new Vector3().fromArray(sample.finger_position_m));
    this.moveFinger({ right_m: x, away_m: -z }, Math.max(1, elapsed_ms));
    this.recordHand();
    this.#endIfOver(y);
  }

  #endIfOver(height_m: number): void {
    const gone_m = length_m(start, this.finger),
      lifted = height_m > liftHeight_m;
    if (lifted && gone_m < minReach_m) return this.restart();
    if (lifted || gone_m > beyond_m || this.command.flags & HRT_COMMAND_ARRIVED) this.#arrive();
  }

  /** Ends the reach. Over a connected, registered plate, a hand at a real cylinder corrects the registration. */
  #arrive(): void {
    this.result = slideEnd(this.finger, this.felt, pageCourse(this.settings.gap_deg));
    this.session.endReach();
    if (!Number.isNaN(this.plateConnected_deg)) {
      const meets = this.hasCylinder && this.result.toCylinder_mm <= 1000 * cylinderRadius_m;
      if (meets && this.session.config.flags & HRT_SESSION_REGISTERED) this.session.reachTouched();
    }
    this.recording = this.cancel();
    this.phase = "arrived";
    this.#resting.reset();
    const { toCylinder_mm, toGlass_mm, feltToGlass_mm } = this.result;
    this.text =
      `Your hand ended ${toCylinder_mm.toFixed(0)} mm from the cylinder and ${toGlass_mm.toFixed(0)} mm from the glass. It felt ` +
      `${feltToGlass_mm.toFixed(0)} mm from the glass. Return to the ring for the next slide.`;
  }
}

function locate(name: XRHandJoint, frame: XRFrame, hand: XRHand | undefined, space: XRReferenceSpace): Vector3 | null {
  const joint = hand?.get(name),
    { x = NaN, y = NaN, z = NaN } = (joint && frame.getJointPose?.(joint, space)?.transform.position) ?? {};
  return Number.isFinite(x + y + z) ? new Vector3(x, y, z) : null;
}

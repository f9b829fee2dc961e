// The mode "Wear it": requests a headset with hand tracking from the browser, and shows the visitor's reaches in it.
import { Vector3 } from "three";
import type { Desk } from "../desk";
import { start } from "../geometry";
import { chosen, element, messageOf, say } from "../page";
import type { Settings } from "../settings";
import { Headset } from "../stage/headset";
import type { HeadsetReach } from "./headset_reach";

type Kind = "immersive-vr" | "immersive-ar";
const kinds: readonly (readonly [Kind, string])[] = [
  ["immersive-vr", "enter-vr"],
  ["immersive-ar", "enter-ar"],
];
/** Offset of the plate from the eyes until it is placed. */
const ahead_m = 0.45,
  below_m = 0.3;
const settle_ms = 400;

export class HeadsetMode {
  readonly #headset: Headset | null;
  readonly #cylinder = element("cylinder", HTMLInputElement);
  readonly #state = element("wear-state", HTMLParagraphElement);
  readonly #leave = element("leave", HTMLButtonElement);
  readonly #buttons = kinds.map(([kind, id]) => ({ kind, button: element(id, HTMLButtonElement), supported: false }));
  #session: XRSession | null = null;
  #handedness: XRHandedness = "none";
  #before_ms = NaN;
  #shift = 0;
  #message = "You need a headset that tracks hands. Open this page in its browser, and slide with your own hand.";
  /** Called in each frame of the headset, so that main.ts commands a connected plate. */
  onFrame: () => void = () => {};
  /** Called when a headset session has ended and the page must draw again. */
  onLeft: () => void = () => {};

  constructor(
    readonly wear: HeadsetReach,
    private readonly desk: Desk,
  ) {
    this.#headset = desk.stage && new Headset(desk.stage);
    wear.onPlaced = (position, rotation) => this.#headset?.put(position, rotation);
    for (const { kind, button } of this.#buttons) button.addEventListener("click", () => this.#enter(kind));
    this.#leave.addEventListener("click", () => this.#session?.end());
    void this.#ask();
    navigator.xr?.addEventListener("devicechange", () => this.#ask());
  }

  /** True while a headset shows the reaches; the page must not draw. */
  get worn(): boolean {
    return this.#session !== null;
  }

  apply(settings: Readonly<Settings>): void {
    this.wear.apply(settings);
  }

  frame(): void {
    this.desk.draw(this.wear);
    this.#show();
  }

  async #ask(): Promise<void> {
    for (const entry of this.#buttons) {
      entry.supported =
        this.desk.stage !== null && ((await navigator.xr?.isSessionSupported(entry.kind).catch(() => false)) ?? false);
      entry.button.disabled = !entry.supported;
    }
    element("wear-unavailable", HTMLParagraphElement).hidden = this.#buttons.some(({ supported }) => supported);
  }

  async #enter(kind: Kind): Promise<void> {
    const headset = this.#headset;
    if (!headset || this.#session || !navigator.xr) return;
    for (const { button } of this.#buttons) button.disabled = true;
    let session: XRSession | null = null;
    try {
      session = await navigator.xr.requestSession(kind, {
        requiredFeatures: ["hand-tracking"],
        optionalFeatures: ["local-floor"],
      });
      session.addEventListener("end", () => this.#left());
      this.#session = session;
      this.#message = "You have left the headset."; // shown when the session has ended
      this.#leave.hidden = false;
      this.#handedness = "none";
      this.#before_ms = NaN;
      this.wear.begin(this.#byMarks);
      headset.show(true);
      await headset.present(
        session,
        kind === "immersive-ar",
        (time_ms, frame, space) => this.#frameWorn(time_ms, frame, space),
        () => {
          this.#before_ms = NaN;
          this.wear.begin(this.#byMarks, "The headset was recentred, so the plate must be placed again. ");
        },
      );
    } catch (error) {
      const why = messageOf(error).replace(/\.$/, "");
      this.#message = `The headset cannot show the plate: ${why}. ${advice(error)}`;
      if (session && this.#session) await session.end().catch(() => this.#left());
      else this.#left();
    }
  }

  #left(): void {
    const was = this.#session;
    this.#session = null;
    this.wear.restart();
    this.#leave.hidden = true;
    for (const { button, supported } of this.#buttons) button.disabled = !supported;
    this.#headset?.show(false);
    if (was) this.onLeft();
  }

  get #byMarks(): boolean {
    return chosen("placement") === "marks";
  }

  /** Processes a frame of the headset. `now_ms`: time of the callback; some browsers have no predictedDisplayTime. */
  #frameWorn(now_ms: number, frame: XRFrame, space: XRReferenceSpace): void {
    const { stage } = this.desk,
      wear = this.wear;
    if (!stage || !this.#session) return;
    if (Number.isNaN(this.#before_ms)) this.#placeAheadOfEyes(frame, space);
    const elapsed_ms = Number.isNaN(this.#before_ms) ? 0 : now_ms - this.#before_ms;
    this.#before_ms = now_ms;
    this.onFrame();
    const hand = this.#hand(frame, space);
    wear.hasCylinder = this.#cylinder.checked;
    wear.frame(now_ms, frame, hand, space);
    stage.place(wear);
    const unfelt = Number.isNaN(wear.plateConnected_deg);
    const title = unfelt ? "SIMULATION: hand drawn where it is felt" : "A plate is connected";
    this.#headset?.say(title, wear.text);
    // Without a connected plate, a sliding hand is drawn at its perceived position. A visitor who steers the drawn hand
    // to the glass thus touches a real object at the cylinder. After the slide, the drawn hand moves to its true
    // position.
    this.#shift = wear.phase === "sliding" && unfelt ? 1 : this.#shift * Math.exp(-elapsed_ms / settle_ms);
    const right_m = this.#shift * (wear.felt.right_m - wear.finger.right_m),
      away_m = this.#shift * (wear.felt.away_m - wear.finger.away_m);
    this.#headset?.shift(right_m, away_m);
    Object.assign(this.desk.frame.dataset, { shiftRightMm: 1000 * right_m, shiftAwayMm: 1000 * away_m }); // for tests
    this.#show();
  }

  #placeAheadOfEyes(frame: XRFrame, space: XRReferenceSpace): void {
    const eyes = frame.getViewerPose(space)?.transform,
      { stage } = this.desk;
    if (!eyes || !stage) return;
    const { x, y, z, w } = eyes.orientation,
      yaw = Math.atan2(2 * (w * y + x * z), 1 - 2 * (x * x + y * y));
    stage.mount.position.set(
      eyes.position.x - ahead_m * Math.sin(yaw),
      eyes.position.y - below_m,
      eyes.position.z - ahead_m * Math.cos(yaw),
    );
    stage.mount.rotation.set(0, yaw, 0);
  }

  /** Returns the hand that makes the slide; between slides, the one nearer to the ring; until the plate is placed, the
   *  one farther from the eyes, seen from above. */
  #hand(frame: XRFrame, space: XRReferenceSpace): XRHand | undefined {
    const { wear } = this,
      eyes = frame.getViewerPose(space)?.transform.position,
      ring = this.desk.stage?.mount.localToWorld(new Vector3(start.right_m, 0, -start.away_m));
    let best: XRHand | undefined,
      least = Infinity;
    for (const { hand, handedness } of this.#session?.inputSources ?? []) {
      const joint = hand?.get("index-finger-tip"),
        pose = joint && frame.getJointPose?.(joint, space);
      if (wear.phase === "sliding") {
        if (handedness === this.#handedness) return hand;
        continue;
      }
      if (!hand || !pose) continue;
      const { x, y, z } = pose.transform.position,
        from =
          wear.phase === "placing"
            ? eyes && -Math.hypot(x - eyes.x, z - eyes.z)
            : ring?.distanceTo(new Vector3(x, y, z));
      if ((from ?? 0) >= least) continue;
      [best, least, this.#handedness] = [hand, from ?? 0, handedness];
    }
    return best;
  }

  #show(): void {
    const wear = this.wear;
    const text = this.#session ? wear.text : this.#message;
    this.desk.caption(wear.phase, text);
    say(this.#state, text);
    Object.assign(this.desk.frame.dataset, { lost: wear.lost, feltDeg: wear.felt_deg }); // for tests
    this.desk.write(wear.result, wear.felt);
  }
}

function advice(error: unknown): string {
  const name = error instanceof Error ? error.name : "";
  if (name === "NotSupportedError")
    return "Switch hand tracking on in the headset's settings, put the controllers down, and enter again.";
  if (name === "SecurityError" || name === "NotAllowedError")
    return "Allow this page to use the headset and to see your hands, when the browser asks or in its site settings.";
  return "Enter again; if that fails too, restart the headset's browser.";
}

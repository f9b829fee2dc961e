// Loads the plugin, connects settings, modes, picture and chart, and draws frames while something moves.
import { load } from "haptic-retargeting";
import pluginModule from "haptic-retargeting/haptic_retargeting.wasm";
import { HapticPlate } from "haptic-retargeting/three";
import type { Chart } from "./chart";
import { Desk } from "./desk";
import { showFigures } from "./figures";
import { FilePanel } from "./files/file_panel";
import type { RecordedReach } from "./files/recording";
import { pageCourse, start } from "./geometry";
import { motionBound_deg } from "./guided_reach";
import { Compare } from "./modes/compare";
import { SceneMode } from "./modes/scene_mode";
import { SlideMode } from "./modes/slide_mode";
import { WatchMode } from "./modes/watch_mode";
import { check, chosen, element, messageOf, part, radios, readColours, report, say } from "./page";
import { PlatePanel } from "./plate/plate_panel";
import { type Mode, modes, SettingsForm } from "./settings";
import { SimulatedReach } from "./simulated_reach";
import { Sounds } from "./sounds";
import { VisitorReach } from "./visitor_reach";
import type { HeadsetMode } from "./wear/headset_mode";
import type { HeadsetReach } from "./wear/headset_reach";

/** A longer frame, as on a slow machine, advances a reach by this time only. */
const maxFrame_ms = 1000;

async function main(): Promise<void> {
  // The first picture, below, is drawn while the plugin is downloaded and compiled.
  const loading = load(pluginModule);
  const desk = new Desk(),
    still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  const form = new SettingsForm(() => {
    const { settings } = form;
    recorded = null;
    watching.apply(settings);
    sliding.apply(settings);
    wearing?.apply(settings);
    showSettings();
    address();
  });
  desk.nameLabels(true);
  desk.reveal(0);
  desk.setColours(readColours());
  desk.setTargets({ ...pageCourse(form.settings.gap_deg), real_deg: 0 });
  desk.resize();
  desk.setView(false);
  desk.draw({ plate_deg: 0, finger: start, felt: start, trace: [] });
  const library = await loading;
  const linked = form.fromLink(location.hash.slice(1)),
    { settings } = form;
  showProblems(linked.problems);
  const watch = new SimulatedReach(library, settings);
  const hand = new VisitorReach(library, settings),
    unguided = new VisitorReach(library, { ...settings, controller: "off" });
  const compare = new Compare(),
    sounds = new Sounds(still),
    plate = new PlatePanel();
  const watching = new WatchMode(watch, desk, still);
  const sliding = new SlideMode(hand, unguided, desk, compare, sounds, settings, still);
  const viewing = new SceneMode(library, settings, showMode);
  let mode: Mode = "hand",
    recorded: RecordedReach | null = null;
  // Null until their parts of the page are loaded.
  let chart: Chart | null = null,
    wearing: HeadsetMode | null = null;

  const files = new FilePanel(
    library,
    () => reaches().recording,
    () => (mode === "scene" ? viewing.watch : watch).profile,
    {
      reach(reach) {
        recorded = reach;
        compare.keep("on", reach.samples, reach.course, reach.name);
        showSettings();
      },
      scene(scene) {
        viewing.show(scene);
        element("scene-mode", HTMLLabelElement).hidden = false;
        choose("scene");
      },
    },
  );

  function address(): void {
    history.replaceState(null, "", `#${form.toLink(mode)}`);
  }

  function shownCourse() {
    return (mode === "scene" && viewing.course) || pageCourse(form.settings.gap_deg);
  }

  function showSettings(): void {
    desk.setTargets(shownCourse());
    form.showMaxGap(motionBound_deg * form.settings.tactile_weight);
  }

  function showMode(): void {
    mode = modes.find((name) => name === chosen("mode")) ?? "hand";
    sliding.active = mode === "hand";
    const { frame } = desk;
    frame.classList.toggle("hand", sliding.active);
    frame.setAttribute(
      "aria-label",
      sliding.active
        ? "The plate: arrow keys slide your hand; steer the dot from the ring to the glass, ahead and somewhat to the left; Enter lifts the hand"
        : "The plate and the hand: arrow keys turn the view",
    );
    const played = mode === "watch" || (mode === "scene" && viewing.course !== null);
    for (const name of [...modes, "played", "own"]) {
      const shown = name === "played" ? played : name === "own" ? mode !== "scene" : name === mode;
      for (const only of document.querySelectorAll<HTMLElement>(`.${name}-only`)) only.hidden = !shown;
    }
    desk.setView(!sliding.active);
    desk.setScene(mode === "scene" ? viewing.scene : null);
    desk.nameLabels(sliding.active || mode === "wear");
    desk.reveal(1);
    if (mode === "scene") watching.play(viewing.watch, viewing.scene?.scale ?? 1);
    else watching.play(watch, 1);
    desk.resize();
    showSettings();
    if (mode === "wear" && !wearing) void bringHeadset();
    if (mode === "hand") sliding.restart();
    else if (mode === "watch") watching.resume();
    else if (mode === "scene") watching.apply(form.settings);
  }

  async function bringHeadset(): Promise<void> {
    const loading = Promise.all([import("./wear/headset_reach"), import("./wear/headset_mode")]),
      parts = await part("The part for headsets", loading);
    if (wearing || !parts) return;
    const [{ HeadsetReach }, { HeadsetMode }] = parts,
      wear = new HeadsetReach(library, desk.stage?.plate ?? new HapticPlate(), form.settings);
    wearing = new HeadsetMode(wear, desk);
    wearing.onFrame = follow;
    wearing.onLeft = () => {
      desk.setView(mode !== "hand");
      desk.resize();
      wake();
    };
    wake();
  }

  function choose(wanted: Mode): void {
    check("mode", wanted);
    showMode();
  }

  function colour(): void {
    const colours = readColours();
    desk.setColours(colours);
    chart?.setColours(colours);
  }

  function reaches(): SimulatedReach | VisitorReach | HeadsetReach {
    return { watch, hand: sliding.hand, wear: wearing?.wear ?? hand, scene: viewing.watch }[mode];
  }

  /** Sends the shown reach's command to a connected plate, whose reported orientation replaces the simulated one. */
  function follow(): void {
    const shown = reaches();
    plate.frame(performance.now(), shown.command.plate_orientation_deg);
    // A simulated reach that is paused or stepped does not run in real time, so it uses the simulated plate.
    const stepped = (mode === "watch" || mode === "scene") && !watching.playing;
    for (const each of [watch, hand, unguided, viewing.watch, ...(wearing ? [wearing.wear] : [])])
      each.plateConnected_deg = each === shown && !stepped ? plate.orientation_deg : NaN;
  }

  plate.onReady = (speed_deg_s) => form.setPlateSpeed(speed_deg_s);

  let before_ms = NaN, // time of the last frame; NaN: no frame is requested
    awake_ms = 0;
  const linger_ms = 300;
  /** Draws frames for `linger_ms`, and then as long as something moves. */
  function wake(): void {
    awake_ms = linger_ms;
    if (!Number.isNaN(before_ms)) return;
    before_ms = performance.now();
    requestAnimationFrame(frame);
  }

  function frame(now_ms: number): void {
    const elapsed_ms = Math.max(0, now_ms - before_ms);
    before_ms = now_ms;
    awake_ms -= elapsed_ms;
    if (!wearing?.worn) {
      if (!still) desk.ease(elapsed_ms);
      follow();
      const shown = { watch: watching, hand: sliding, wear: wearing, scene: watching }[mode];
      shown?.frame(Math.min(elapsed_ms, maxFrame_ms));
    }
    const weight = recorded ? NaN : form.settings.tactile_weight;
    chart?.draw(recorded?.samples ?? reaches().trace, recorded?.course ?? shownCourse(), weight);
    files.allow(reaches().recording !== "");
    const moving = mode === "hand" ? sliding.busy : mode !== "wear" && watching.playing;
    if (moving || awake_ms > 0 || plate.connected) requestAnimationFrame(frame);
    else before_ms = NaN;
  }
  for (const event of ["pointerdown", "pointermove", "keydown", "keyup", "click", "input", "change", "drop", "resize"])
    window.addEventListener(event, wake, { passive: true, capture: true });
  document.addEventListener("visibilitychange", () => {
    if (!Number.isNaN(before_ms)) before_ms = performance.now();
  });

  for (const radio of radios("mode")) {
    radio.addEventListener("change", () => {
      if (wearing?.worn) check("mode", "wear"); // the headset's session must end first
      showMode();
      address();
    });
  }
  new ResizeObserver(() => {
    desk.resize();
    wake();
  }).observe(desk.frame);
  async function bringChart(): Promise<void> {
    const loaded = await part("The chart", import("./chart"));
    if (loaded) chart = new loaded.Chart(element("chart", HTMLDivElement));
    wake();
  }
  desk.frame.addEventListener("keydown", (event) => {
    if (!sliding.active && desk.turn(event.key)) event.preventDefault();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", colour);
  window.addEventListener("hashchange", () => location.reload());
  colour();
  choose(linked.mode);
  element("main", HTMLElement).inert = false;
  document.documentElement.dataset.ready = "yes";
  desk.onRestored = wake;
  if (!document.body.classList.contains("researchers")) showFigures(library);
  else void bringChart();
  wake();
  await part("The hand", desk.bringHand());
  wake();
}

function showProblems(problems: readonly string[]): void {
  report(problems.length === 0 ? "" : `Ignored in the link: ${problems.join("; ")}.`);
}

element("retry", HTMLButtonElement).addEventListener("click", () => location.reload());
main().catch((error: unknown) => {
  element("main", HTMLElement).inert = false;
  document.body.classList.add("failed");
  say(element("caption", HTMLParagraphElement), "");
  report(`The page cannot start: ${messageOf(error)}. Check the connection, then try again.`, true);
  throw error;
});

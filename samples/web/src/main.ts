// Loads plugin and simulation, connects settings, modes, picture and chart, and draws frames while something moves.
import { load } from "haptic-retargeting";
import pluginModule from "haptic-retargeting/haptic_retargeting.wasm";
import { HapticPlate } from "haptic-retargeting/three";
import type { Chart } from "./chart";
import { motionBound_deg, pageCourse } from "./controller";
import { Desk } from "./desk";
import { showFigures } from "./figures";
import type { RecordedReach } from "./files/recording";
import { TakeAway } from "./files/takeaway";
import { distance_m, start } from "./geometry";
import { Compare } from "./modes/compare";
import { SceneMode } from "./modes/scene_mode";
import { SlideMode } from "./modes/slide_mode";
import { WatchMode } from "./modes/watch_mode";
import { check, chosen, element, messageOf, part, radios, report, say } from "./page";
import { Panel } from "./panel";
import { createWorld } from "./person";
import { PlatePanel } from "./plate/plate_panel";
import { Results } from "./results";
import { defaultSettings, fromLink, type Mode, modes, onSlider, toLink } from "./settings";
import { SimulatedReach } from "./simulated_reach";
import { Sounds } from "./sounds";
import { readColours } from "./theme";
import { TraceTable } from "./trace";
import { VisitorReach } from "./visitor_reach";
import { Voice } from "./voice";
import type { HeadsetMode } from "./wear/headset_mode";
import type { HeadsetReach } from "./wear/headset_reach";

/** Longest time by which one frame advances a reach: slow machines keep real time, and a hidden page continues where it stopped. */
const maxFrame_ms = 1000;

async function main(): Promise<void> {
  // The modules are compiled while they are downloaded. The first picture does not need them.
  const loading = Promise.all([load(pluginModule), createWorld(), createWorld(), createWorld(), createWorld()]);
  const desk = new Desk(),
    still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  desk.nameLabels(true);
  desk.reveal(0);
  desk.setColours(readColours());
  desk.setTargets(0, pageCourse(defaultSettings()).virtual_deg, distance_m);
  desk.resize();
  desk.setView(false);
  desk.draw(0, start, start);
  const [library, watchWorld, handWorld, sceneWorld, figureWorld] = await loading;
  const linked = fromLink(location.hash.slice(1));
  showProblems(linked.problems);
  const watch = new SimulatedReach(library, watchWorld, linked.settings);
  const hand = new VisitorReach(library, handWorld, linked.settings),
    unguided = new VisitorReach(library, handWorld, { ...linked.settings, controller: "off" });
  const compare = new Compare(),
    voice = new Voice(),
    sounds = new Sounds(still),
    plate = new PlatePanel(),
    results = new Results();
  const table = new TraceTable();
  const watching = new WatchMode(watch, watchWorld, desk, results, linked.settings, voice, still);
  const sliding = new SlideMode(hand, unguided, handWorld, desk, compare, voice, sounds, linked.settings, still);
  const viewing = new SceneMode(library, sceneWorld, linked.settings, showMode);
  let mode: Mode = "hand",
    recorded: RecordedReach | null = null;
  // Parts that are loaded when they are needed.
  let chart: Chart | null = null,
    wearing: HeadsetMode | null = null;

  const goals = { real_deg: 0, virtual_deg: 0, weight: NaN };
  const takeAway = new TakeAway(
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

  const panel = new Panel(linked.settings, () => {
    const { settings } = panel;
    recorded = null;
    watching.apply(settings);
    sliding.apply(settings);
    wearing?.apply(settings);
    showSettings();
    address();
  });

  function address(): void {
    history.replaceState(null, "", `#${toLink(panel.settings, mode)}`);
  }

  function showSettings(): void {
    const { settings } = panel,
      course = (mode === "scene" && viewing.course) || pageCourse(settings);
    const { real_deg, virtual_deg } = recorded?.course ?? course;
    Object.assign(goals, { real_deg, virtual_deg, weight: recorded ? NaN : settings.tactile_weight });
    desk.setTargets(course.real_deg, course.virtual_deg, course.real_m);
    panel.showMaxGap(watchWorld.max_gap_deg(motionBound_deg));
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
    desk.nameLabels(sliding.active);
    desk.reveal(1);
    if (mode === "scene") watching.play(viewing.watch, sceneWorld, viewing.scene?.scale ?? 1);
    else watching.play(watch, watchWorld, 1);
    desk.resize();
    showSettings();
    if (mode === "wear" && !wearing) void bringHeadset();
    if (mode === "hand") sliding.restart();
    else if (mode === "watch") watching.resume();
    else if (mode === "scene") watching.apply(panel.settings);
  }

  async function bringHeadset(): Promise<void> {
    const loading = Promise.all([createWorld(), import("./wear/headset_reach"), import("./wear/headset_mode")]),
      parts = await part("The part for headsets", loading);
    if (wearing || !parts) return;
    const [world, { HeadsetReach }, { HeadsetMode }] = parts,
      { settings } = panel,
      wear = new HeadsetReach(library, world, desk.stage?.plate ?? new HapticPlate(), settings);
    wearing = new HeadsetMode(wear, world, desk, voice);
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

  /** Returns the object whose reaches are shown. */
  function reaches(): SimulatedReach | VisitorReach | HeadsetReach {
    return { watch, hand: sliding.hand, wear: wearing?.wear ?? hand, scene: viewing.watch }[mode];
  }

  /** Commands a connected plate, whose reported orientation then replaces the simulated one. */
  function follow(): void {
    const shown = reaches();
    plate.frame(performance.now(), shown.command.plate_orientation_deg);
    // Reaches that are computed immediately or step by step do not run in the real time of a plate.
    const stepped = (mode === "watch" || mode === "scene") && !watching.playing;
    for (const each of [watch, hand, unguided, viewing.watch, ...(wearing ? [wearing.wear] : [])])
      each.plateConnected_deg = each === shown && !stepped ? plate.orientation_deg : NaN;
  }

  plate.onReady = ({ speed_deg_s }) => panel.change({ plate_deg_s: onSlider("plate_deg_s", speed_deg_s) });

  /** Requests frames for a short time after input or the loading of a part, and as long as something moves. */
  let before_ms = NaN,
    awake_ms = 0;
  const linger_ms = 300;
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
    const trace = recorded?.samples ?? reaches().trace;
    chart?.draw(trace, goals);
    table.show(trace);
    takeAway.allow(reaches().recording !== "");
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
  window.addEventListener("hashchange", () => {
    const { settings, mode: wanted, problems } = fromLink(location.hash.slice(1));
    showProblems(problems);
    choose(wanted);
    panel.change(settings);
    wake();
  });
  colour();
  choose(linked.mode);
  element("main", HTMLElement).inert = false;
  document.documentElement.dataset.ready = "yes";
  desk.onRestored = wake;
  if (!document.body.classList.contains("researchers")) showFigures(library, figureWorld);
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

// The page: loads plugin and simulation, connects settings, modes, picture and chart, and runs the frames.
import { load } from "haptic-retargeting";
import pluginModule from "haptic-retargeting/haptic_retargeting.wasm";
import { HapticPlate } from "haptic-retargeting/three";
import type { Chart } from "./chart";
import { motionBound_deg, pageCourse } from "./controller";
import { Desk } from "./desk";
import { showFigures } from "./figures";
import { TakeAway } from "./files/takeaway";
import { distance_m, start } from "./geometry";
import { Hand } from "./hand";
import { Replaying } from "./modes/replaying";
import { Sliding } from "./modes/sliding";
import { Viewing } from "./modes/viewing";
import { Watching } from "./modes/watching";
import { check, chosen, element, messageOf, radios, say } from "./page";
import { Panel } from "./panel";
import { createWorld } from "./person";
import { Connecting } from "./plate/connecting";
import { Results } from "./results";
import { defaultSettings, fromLink, type Mode, modes, onSlider, toLink } from "./settings";
import { readColours } from "./theme";
import { Ticks } from "./ticks";
import { TraceTable } from "./trace";
import { Voice } from "./voice";
import { Watch } from "./watch";
import type { Wear } from "./wear/wear";
import type { Wearing } from "./wear/wearing";

/** A page that was hidden continues where it was. */
const maxFrame_ms = 100;

async function main(): Promise<void> {
  // The first picture needs no plugin, which is on its way meanwhile.
  const desk = new Desk(),
    still = matchMedia("(prefers-reduced-motion: reduce)").matches;
  desk.nameLabels(true);
  desk.reveal(0);
  desk.setColours(readColours());
  desk.setTargets(0, pageCourse(defaultSettings()).virtual_deg, distance_m);
  desk.resize();
  desk.setView(false);
  desk.draw(0, start, start);
  showFigures();
  const [library, watchWorld, handWorld, sceneWorld] = await Promise.all([
    load(pluginModule),
    createWorld(),
    createWorld(),
    createWorld(),
  ]);
  const linked = fromLink(location.hash.slice(1));
  showProblems(linked.problems);
  // A link that says more than the address is a researcher's.
  if (location.hash !== "") for (const part of document.querySelectorAll("details")) part.open = true;

  const watch = new Watch(library, watchWorld, linked.settings);
  const hand = new Hand(library, handWorld, linked.settings),
    plain = new Hand(library, handWorld, { ...linked.settings, controller: "off" });
  const voice = new Voice(),
    plate = new Connecting(),
    results = new Results();
  const table = new TraceTable(),
    researchers = element("researchers", HTMLDetailsElement);
  const watching = new Watching(watch, watchWorld, desk, results, linked.settings, voice, still);
  const sliding = new Sliding(hand, plain, handWorld, desk, voice, new Ticks(still), linked.settings, still);
  const replaying = new Replaying(desk, still);
  const viewing = new Viewing(library, sceneWorld, linked.settings, showMode);
  let mode: Mode = "hand";
  // These come when asked for.
  let chart: Chart | null = null,
    wearing: Wearing | null = null;

  const goals = { real_deg: 0, virtual_deg: 0, weight: NaN };
  const takeAway = new TakeAway(
    library,
    () => reaches().recording,
    () => (mode === "scene" ? viewing.watch : watch).profile,
    {
      reach(reach) {
        replaying.show(reach);
        reveal("replay");
      },
      scene(scene) {
        viewing.show(scene);
        reveal("scene");
      },
    },
  );

  const panel = new Panel(linked.settings, () => {
    const { settings } = panel;
    if (mode === "replay") choose("watch");
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
      reach = mode === "replay" ? replaying.reach : null;
    const { real_deg, virtual_deg, real_m } = reach ?? ((mode === "scene" && viewing.course) || pageCourse(settings));
    Object.assign(goals, { real_deg, virtual_deg, weight: reach ? NaN : settings.tactile_weight });
    desk.setTargets(real_deg, virtual_deg, real_m);
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
        ? "The plate: arrow keys slide your hand; steer the dot from the ring to the glass, ahead and somewhat to the left; Enter lifts the finger"
        : "The plate and the hand: arrow keys turn the view",
    );
    const played = mode === "watch" || (mode === "scene" && viewing.course !== null);
    for (const name of [...modes, "played", "own"]) {
      const shown = name === "played" ? played : name === "own" ? mode !== "scene" : name === mode;
      for (const part of document.querySelectorAll<HTMLElement>(`.${name}-only`)) part.hidden = !shown;
    }
    element("legend", HTMLParagraphElement).hidden = mode === "replay";
    say(
      element("now-title", HTMLHeadingElement),
      mode === "replay" ? "What the controller believed" : "What is felt now",
    );
    desk.setView(!sliding.active);
    desk.setScene(mode === "scene" ? viewing.scene : null);
    desk.nameLabels(sliding.active);
    desk.reveal(1);
    desk.showFelt(mode !== "replay");
    if (mode === "scene") watching.play(viewing.watch, sceneWorld, viewing.scene?.scale ?? 1);
    else watching.play(watch, watchWorld, 1);
    desk.resize();
    showSettings();
    if (mode === "wear" && !wearing) void bringHeadset();
    if (mode === "hand") sliding.restart();
    else if (mode === "watch") watching.resume();
    else if (mode === "replay" && replaying.reach) replaying.show(replaying.reach);
    else if (mode === "scene") watching.apply(panel.settings);
  }

  async function bringHeadset(): Promise<void> {
    const [world, { Wear }, { Wearing }] = await Promise.all([
      createWorld(),
      import("./wear/wear"),
      import("./wear/wearing"),
    ]);
    if (wearing) return;
    const { settings } = panel,
      wear = new Wear(library, world, desk.stage?.plate ?? new HapticPlate(), settings);
    wearing = new Wearing(wear, world, desk, voice, settings);
    wearing.onFrame = follow;
    wearing.onLeft = () => {
      desk.setView(mode !== "hand");
      desk.resize();
    };
  }

  function choose(wanted: Mode): void {
    check("mode", wanted);
    showMode();
  }

  function reveal(brought: "replay" | "scene"): void {
    element(`${brought}-mode`, HTMLLabelElement).hidden = false;
    choose(brought);
  }

  function colour(): void {
    const colours = readColours();
    desk.setColours(colours);
    chart?.setColours(colours);
  }

  /** Whose reaches are shown. */
  function reaches(): Watch | Hand | Wear {
    return { watch, hand: sliding.hand, wear: wearing?.wear ?? hand, replay: watch, scene: viewing.watch }[mode];
  }

  /** A connected plate does what the controller commands, and is felt where it is. */
  function follow(elapsed_ms: number): void {
    const shown = reaches();
    plate.frame(elapsed_ms, performance.now(), shown.command.plate_orientation_deg);
    // Reaches that are computed at once, or by steps, are not at the plate's time.
    const stepped = (mode === "watch" || mode === "scene") && !watching.playing;
    for (const each of [watch, hand, plain, viewing.watch, ...(wearing ? [wearing.wear] : [])])
      each.plateConnected_deg = each === shown && !stepped ? plate.orientation_deg : NaN;
  }

  plate.onReady = ({ speed_deg_s }) => panel.change({ plate_deg_s: onSlider("plate_deg_s", speed_deg_s) });

  let before_ms = performance.now();
  function frame(now_ms: number): void {
    const elapsed_ms = Math.max(0, now_ms - before_ms);
    before_ms = now_ms;
    if (!wearing?.worn) {
      if (!still) desk.ease(elapsed_ms);
      follow(elapsed_ms);
      const shown = { watch: watching, hand: sliding, wear: wearing, replay: replaying, scene: watching }[mode];
      shown?.frame(Math.min(elapsed_ms, maxFrame_ms));
    }
    const { trace } = mode === "replay" ? replaying : reaches();
    if (researchers.open) chart?.draw(trace, goals);
    table.show(trace);
    takeAway.allow(reaches().recording !== "");
    requestAnimationFrame(frame);
  }

  for (const radio of radios("mode")) {
    radio.addEventListener("change", () => {
      if (wearing?.worn) check("mode", "wear"); // the headset's session goes first
      showMode();
      address();
    });
  }
  new ResizeObserver(() => desk.resize()).observe(desk.canvas);
  researchers.addEventListener("toggle", () => {
    if (!chart)
      void import("./chart").then((part) => {
        chart ??= new part.Chart(element("chart", HTMLDivElement));
      });
  });
  desk.frame.addEventListener("keydown", (event) => {
    if (!sliding.active && desk.turn(event.key)) event.preventDefault();
  });
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", colour);
  window.addEventListener("hashchange", () => {
    const { settings, mode: wanted, problems } = fromLink(location.hash.slice(1));
    showProblems(problems);
    choose(wanted);
    panel.change(settings);
  });
  for (const button of document.querySelectorAll<HTMLButtonElement>("button[data-open]")) {
    const part = element(button.dataset.open ?? "", HTMLDetailsElement);
    button.addEventListener("click", () => {
      part.open = true;
      part.scrollIntoView({ behavior: still ? "auto" : "smooth" });
      part.querySelector("summary")?.focus({ preventScroll: true });
    });
  }
  colour();
  choose(linked.mode);
  document.documentElement.dataset.ready = "yes";
  void desk.bringHand();
  requestAnimationFrame(frame);
}

function showProblems(problems: readonly string[]): void {
  const place = element("problem", HTMLParagraphElement);
  place.hidden = problems.length === 0;
  say(place, problems.length === 0 ? "" : `Left out of the link: ${problems.join("; ")}.`);
}

main().catch((error: unknown) => {
  const caption = document.getElementById("caption");
  if (caption) caption.textContent = `The page cannot start: ${messageOf(error)}`;
  throw error;
});

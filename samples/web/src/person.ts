// The simulated world: person, plate and tracker of core/simulation, in a WebAssembly module of their own (person.cpp).
import personModule from "person.wasm";
import type { Place } from "./geometry";

type Does =
  | "set_person"
  | "set_apparatus"
  | "begin_reach"
  | "begin_hand"
  | "advance"
  | "look"
  | "command"
  | "set_plate";
type Plate = "time_ms" | "plate_deg" | "plate_latency_ms" | "felt_shift_deg" | "max_gap_deg";
type Finger = "moving" | "over" | "finger_right_m" | "finger_away_m" | "finger_deg" | "seen_right_m" | "seen_away_m";
type Felt = "felt_right_m" | "felt_away_m" | "felt_error_deg" | "peak_felt_error_deg";
type Series = "begin_series" | "answer" | "next_gap_deg" | "limit_deg" | "limit_lower_deg" | "limit_upper_deg";
/** The exports of person.cpp, which documents them. */
export type World = Readonly<Record<Does | Plate | Finger | Felt | Series, (...values: number[]) => number>>;

/** Returns the true and the perceived position of the simulated fingertip, multiplied by `scale`. */
export function places(world: World, scale = 1): { finger: Place; felt: Place } {
  return {
    finger: { right_m: scale * world.finger_right_m(), away_m: scale * world.finger_away_m() },
    felt: { right_m: scale * world.felt_right_m(), away_m: scale * world.felt_away_m() },
  };
}

let compiled: Promise<WebAssembly.Module> | null = null;

async function compile(): Promise<WebAssembly.Module> {
  return WebAssembly.compile(
    typeof personModule === "string" ? await (await fetch(personModule)).arrayBuffer() : personModule,
  );
}

/** Creates a world of its own, with one person, one plate and one tracker. */
export async function createWorld(): Promise<World> {
  compiled ??= compile();
  const proc_exit = () => {
    throw new Error("the simulation has run out of memory; reload the page");
  };
  const { exports } = await WebAssembly.instantiate(await compiled, { wasi_snapshot_preview1: { proc_exit } });
  if (typeof exports._initialize === "function") exports._initialize();
  return exports as unknown as World;
}

// The simulated side: core's person, plate and tracker in a WebAssembly module of their own (person.cpp).
import personModule from "person.wasm";

/** The exports of person.cpp, which documents them. */
export interface World {
  set_person(seed: number, tactileWeight: number, duration_s: number): void;
  set_apparatus(noise_m: number, maxSpeed_deg_s: number): void;
  plate_latency_ms(): number;
  begin_reach(
    number: number,
    startRight_m: number,
    startAway_m: number,
    virtual_deg: number,
    distance_m: number,
    plate_deg: number,
  ): void;
  begin_hand(plate_deg: number): void;
  advance(): void;
  look(): void;
  command(plate_deg: number): void;
  set_plate(plate_deg: number): void;
  time_ms(): number;
  plate_deg(): number;
  moving(): number;
  over(): number;
  finger_right_m(): number;
  finger_away_m(): number;
  felt_right_m(): number;
  felt_away_m(): number;
  finger_deg(): number;
  felt_error_deg(): number;
  peak_felt_error_deg(): number;
  seen_right_m(): number;
  seen_away_m(): number;
  felt_shift_deg(plate_deg: number, finger_deg: number): number;
  max_gap_deg(bound_deg: number): number;
  begin_series(min_gap_deg: number, max_gap_deg: number): void;
  answer(gap_deg: number, noticed: number): void;
  next_gap_deg(): number;
  limit_deg(): number;
  limit_lower_deg(): number;
  limit_upper_deg(): number;
}

let compiled: Promise<WebAssembly.Module> | null = null;

async function compile(): Promise<WebAssembly.Module> {
  return WebAssembly.compile(
    typeof personModule === "string" ? await (await fetch(personModule)).arrayBuffer() : personModule,
  );
}

/** A world of its own: one person, one plate, one tracker. */
export async function createWorld(): Promise<World> {
  compiled ??= compile();
  const proc_exit = () => {
    throw new Error("the simulation has run out of memory");
  };
  const { exports } = await WebAssembly.instantiate(await compiled, { wasi_snapshot_preview1: { proc_exit } });
  if (typeof exports._initialize === "function") exports._initialize();
  return exports as unknown as World;
}

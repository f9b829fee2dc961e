// Code of a host in TypeScript, which is compiled but not run. @ts-expect-error: the next line must not compile.
import * as hrt from "haptic-retargeting";
import wasm from "haptic-retargeting/haptic_retargeting.wasm";

async function host(bytes: ArrayBuffer): Promise<number> {
  const library = await hrt.load(new URL("https://localhost/haptic_retargeting.wasm"));
  const bundled: hrt.Library = await hrt.load(wasm);
  library.createSession()[Symbol.dispose]();
  const person: hrt.Person = bundled.createPerson(7n, { tactile_weight: 0.2 });
  const session: hrt.Session = library.createSession({ horizon: 20, plate_latency_ns: 30_000_000 });
  const real: hrt.TargetId = session.addTarget({ role: hrt.HRT_TARGET_REAL, name: "cylinder" });
  const virtual = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, direction_deg: 5 });
  session.configure({ start_position_m: [0, 0, 0.05], plate_latency_ns: 1n });
  const margin: number = session.gap(real, virtual).margin_deg;
  const best: hrt.TargetId = session.assign([virtual], [real])[0].real_target;

  session.startRecording();
  session.beginReach(best, virtual, 10);
  session.sample.flags = hrt.HRT_SAMPLE_PLATE_POSITION;
  session.sample.time_ns = performance.now() * 1e6;
  session.sample.finger_position_m[0] = margin;
  session.setFinger({ transform: { position: { x: 0, y: 0, z: 0 } } }, performance.now());
  session.setFinger(null, 1);
  const tip = { position: { x: 0, y: 0, z: 0 }, orientation: { x: 0, y: 0, z: 0, w: 1 } };
  session.setFinger({ transform: tip }, 1);
  session.setFinger(tip, 1);
  session.setPlate(tip);
  session.update();
  person.begin(session, virtual);
  person.move(session.sample, 1, 30);
  const felt: number[] = person.state.felt_position_m;
  const plate: number = session.command.plate_orientation_deg + session.command.paper_step;
  const samples: bigint = session.endReach().samples;
  const report = library.replay(session.stopRecording());
  const same: boolean = report.hash === samples;

  session.beginSetup(hrt.HRT_SETUP_ALL_MISSING, { max_slides: 40 });
  const step = session.updateSetup();
  if (step.instruction !== hrt.HRT_STEP_FINISH) session.cancelSetup();
  const known: number = session.finishSetup().tactile_weight.known + step.text.length;
  session.loadProfile(session.profile);
  const names: string[] = library.loadScene(bytes, "desk").targets.map((target) => target.name);

  // @ts-expect-error: no such field
  session.sample.finger_positon_m = [0, 0, 0];
  // @ts-expect-error: a time is needed
  session.setFinger(null);
  // @ts-expect-error: no such field
  library.createSession({ horizont: 3 });
  // @ts-expect-error: the library sets this field
  library.createSession({ struct_size: 248 });
  // @ts-expect-error: a number is needed
  library.createSession({ horizon: "3" });
  // @ts-expect-error: only the plugin writes the command
  session.command.flags = 1;
  // @ts-expect-error: ids are not names
  session.removeTarget("cup");

  try {
    session.update();
  } catch (error) {
    if (error instanceof hrt.HapticRetargetingError) return error.code + error.codeName.length;
  }
  return plate + known + felt.length + names.length + (same ? 1 : 0);
}

export default host;

// Haptic retargeting with react-three-fiber: the script of a page, for any bundler that supports JSX.
import { Canvas, useFrame } from "@react-three/fiber";
import * as hrt from "haptic-retargeting";
import { HandReach, HapticPlate, trackedHand } from "haptic-retargeting/three";
import { useEffect, useState } from "react";
import { createRoot } from "react-dom/client";
import { Vector3 } from "three";
import { VRButton } from "three/addons/webxr/VRButton.js";

const start = new Vector3(0, 0, 0.05);

/** A plate and its reaches: `targets` are directions in degrees; `onBegin` and `onEnd` are called for each reach. */
function Plate({ library, real_deg = -5, virtual_deg = 5, onBegin, onEnd, ...place }) {
  const [held, hold] = useState(null);
  useEffect(() => {
    const session = library.createSession({ lift_height_m: 0.05 });            // no surface supports the finger
    const real = session.addTarget({ role: hrt.HRT_TARGET_REAL, direction_deg: real_deg });
    const virtual = session.addTarget({ role: hrt.HRT_TARGET_VIRTUAL, direction_deg: virtual_deg });
    const plate = new HapticPlate();
    hold({ session, plate, targets: [real, virtual], reach: new HandReach(session, plate), tip: new Vector3() });
    return () => { hold(null); session.destroy(); };
  }, [library, real_deg, virtual_deg]);

  useFrame(({ gl }, _, frame) => {
    const space = gl.xr.getReferenceSpace();
    if (!frame || !space || !held) return;
    const { session, plate, targets, reach, tip } = held, hand = trackedHand(frame);
    if (session.state & hrt.HRT_STATE_REACHING) {
      const { flags } = reach.updateFromHand(performance.now(), frame, hand, space);  // send plate.orientation_deg to your plate
      if (flags & hrt.HRT_COMMAND_ARRIVED) onEnd(session.endReach().miss_deg);
      return;
    }
    const pose = hand && frame.getJointPose(hand.get("index-finger-tip"), space);
    if (!pose || plate.worldToLocal(tip.copy(pose.transform.position)).distanceTo(start) > 0.015) return;
    session.beginReach(...targets, plate.orientation_deg);
    onBegin();
  });
  return held && <primitive object={held.plate} {...place}>
    {[[real_deg, "#1f5a97"], [virtual_deg, "#b04a00"]].map(([deg, color]) => <group key={color} position-z={0.05} rotation-y={deg * Math.PI / 180}>
      <mesh position={[0, 0.015, -0.1]}><cylinderGeometry args={[0.005, 0.005, 0.03]} /><meshStandardMaterial color={color} /></mesh></group>)}
  </primitive>;
}

function Page({ library }) {
  const [words, say] = useState("Enter VR, and rest your index fingertip at the near end of the plate.");
  return <>
    <p id="words">{words}</p>
    <Canvas style={{ height: 300 }} onCreated={({ gl }) => {
      gl.xr.enabled = true;
      gl.xr.setReferenceSpaceType("local");
      document.body.append(VRButton.createButton(gl, { requiredFeatures: ["hand-tracking"] }));
    }}>
      <hemisphereLight intensity={3} />
      <Plate library={library} position={[0, -0.35, -0.4]} onBegin={() => say("Slide to the orange cup.")}
             onEnd={(miss_deg) => say(`The finger ended ${miss_deg.toFixed(1)} degrees from the cylinder.`)} />
    </Canvas>
  </>;
}

createRoot(document.body.appendChild(document.createElement("main"))).render(<Page library={await hrt.load()} />);

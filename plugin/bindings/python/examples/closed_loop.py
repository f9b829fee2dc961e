"""A study in a few lines: how a person's share of touch decides how far the hand can be bent, with and without
learning it. The person is simulated, by the paper's equations (section II-A); nothing here was measured on people.

    usage: python3 closed_loop.py
"""

import math

import numpy as np

import haptic_retargeting as hrt

STEP_NS = 100_000_000
MOTOR_VARIANCE, SENSORY_VARIANCE = 0.5, 0.1  # of each step, degrees squared
REACHES, STEPS = 50, 30
REAL_DEG, VIRTUAL_DEG = -5.0, 5.0


def final_direction_deg(session: hrt.Session, tactile_weight: float, random: np.random.Generator) -> float:
    """Where the finger goes in the last step of one reach of a person with this share of touch."""
    finger_deg, variance = 0.0, 0.0
    with session.reach(session.target("cylinder"), session.target("cup"), plate_orientation_deg=0) as reach:
        for step in range(STEPS):
            plate_deg = reach.update(step * STEP_NS, direction_deg=finger_deg).plate_orientation_deg
            # What the person feels, by a Kalman filter whose prior is the direction that they go for.
            prior = variance + MOTOR_VARIANCE
            gain = prior / (prior + SENSORY_VARIANCE)
            variance = (1 - gain) * prior
            felt_deg = tactile_weight * plate_deg + (1 - tactile_weight) * finger_deg
            noise = math.sqrt(MOTOR_VARIANCE + variance) * random.standard_normal()
            finger_deg += -gain * (felt_deg - VIRTUAL_DEG) + noise
    return finger_deg


def main() -> None:
    print(f"The real target is at {REAL_DEG:+g} degrees, the virtual one at {VIRTUAL_DEG:+g}. {REACHES} simulated reaches "
          "each: mean and standard deviation of the final direction.\nshare of touch   known to be 0.15   learnt")
    for tactile_weight in (0.12, 0.15, 0.20, 0.25):
        cells = []
        for adaptation in (hrt.Adaptation.OFF, hrt.Adaptation.REACH):
            random = np.random.default_rng(1)
            with hrt.Session(guidance=hrt.Guidance.FIXED_DIRECTION, adaptation=adaptation, tactile_weight=0.15) as session:
                session.add_real("cylinder", direction_deg=REAL_DEG)
                session.add_virtual("cup", direction_deg=VIRTUAL_DEG)
                ends = [final_direction_deg(session, tactile_weight, random) for _ in range(REACHES)]
            cells.append(f"{np.mean(ends):+6.2f} +- {np.std(ends, ddof=1):.2f}")
        print(f"{tactile_weight:14.2f}   {cells[0]:>18}   {cells[1]}")


main()

"""Finds a person's parameters from slides over a plate at rest. The person is simulated, by the paper's equations
(section II-A); nothing here was measured on people.

    usage: python3 calibrate.py
"""

import math
from typing import Any

import numpy as np

import haptic_retargeting as hrt

TRUTH = {"tactile_weight": 0.11, "bias_deg": 2.0, "tracker_noise_m": 0.0003}
MOTOR_VARIANCE_DEG2, SENSORY_VARIANCE_DEG2 = 0.5, 0.1
RATE_HZ, REST_S, SLIDE_S, SPEED_M_S, STEP_S = 90, 0.5, 3.0, 0.1 / 3, 0.1


def slide(plate_deg: float, random: np.random.Generator) -> "np.ndarray[Any, np.dtype[np.void]]":
    """Half a second at rest, then ten centimetres towards a target straight ahead."""
    directions, finger_deg, variance = [], 0.0, 0.0
    for _ in range(round(SLIDE_S / STEP_S)):
        directions.append(finger_deg)
        prior = variance + MOTOR_VARIANCE_DEG2
        gain = prior / (prior + SENSORY_VARIANCE_DEG2)
        variance = (1 - gain) * prior
        felt_deg = TRUTH["tactile_weight"] * plate_deg + (1 - TRUTH["tactile_weight"]) * finger_deg
        noise = math.sqrt(MOTOR_VARIANCE_DEG2 + variance) * random.standard_normal()
        finger_deg += -gain * (felt_deg - TRUTH["bias_deg"]) + noise

    angles = np.radians(directions)
    corners = STEP_S * SPEED_M_S * np.cumsum([[0, 0], *np.column_stack((-np.sin(angles), np.cos(angles)))], axis=0)
    time_s = np.arange(round((REST_S + SLIDE_S) * RATE_HZ)) / RATE_HZ
    steps = np.clip(time_s - REST_S, 0, SLIDE_S) / STEP_S
    right, away = (np.interp(steps, np.arange(len(corners)), column) for column in corners.T)
    position = np.column_stack((right, np.zeros_like(right), 0.05 - away))
    position[:, [0, 2]] += TRUTH["tracker_noise_m"] * random.standard_normal((len(position), 2))
    return hrt.samples(np.round(time_s * 1e9).astype(np.int64), position_m=position)


def main() -> None:
    random = np.random.default_rng(1)
    with hrt.Session() as session, hrt.Calibration(session) as calibration:
        for plate_deg in random.permutation([-60, -30, 0, 30, 60] * 8):
            calibration.add_trial(float(plate_deg), slide(float(plate_deg), random))
        result = calibration.solve()
        session.apply_calibration(result)
        profile = session.profile
    print(f"{result.trials_used} simulated slides\n{'':24}truth   estimate (95 % interval)")
    for name, truth in TRUTH.items():
        estimate = getattr(result, name)
        shown = f"{estimate.value:.4g} ({estimate.lower:.4g} to {estimate.upper:.4g})" if estimate.known else "not known"
        print(f"{name:24}{truth:<7g} {shown}")
    print("profile:", profile)


main()

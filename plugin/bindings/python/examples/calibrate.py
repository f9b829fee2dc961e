"""Finds a person's parameters from slides over a plate at rest. The person is simulated; nothing here was measured on people.

    usage: python3 calibrate.py
"""

from typing import Any

import numpy as np

import haptic_retargeting as hrt

TRUTH = {"tactile_weight": 0.2, "bias_deg": 2.0, "tracker_noise_m": 0.0005}
FRAMES = 220  # of 90 Hz: half a second at rest, then the slide


def simulated() -> hrt.Person:
    return hrt.Person(1, tactile_weight=TRUTH["tactile_weight"], bias_deg=TRUTH["bias_deg"],
                      tracker_noise_m=TRUTH["tracker_noise_m"])


def slide(session: hrt.Session, person: hrt.Person, plate_deg: float) -> "np.ndarray[Any, np.dtype[np.void]]":
    """Ten centimetres towards a target straight ahead."""
    person.begin(session, session.target("ahead"))
    seen = [person.move(frame * 11_111_111, plate_deg) for frame in range(FRAMES)]
    return hrt.samples([sample.time_ns for sample in seen], position_m=[sample.finger_position_m[:] for sample in seen])


def main() -> None:
    random = np.random.default_rng(1)
    with hrt.Session() as session, hrt.Calibration(session) as calibration, simulated() as person:
        session.add_virtual("ahead", direction_deg=0)
        for plate_deg in random.permutation([-60.0, -30.0, 0.0, 30.0, 60.0] * 8):
            calibration.add_trial(plate_deg, slide(session, person, plate_deg))
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

"""Estimates a person's parameters from slides over a plate at rest. The person is simulated; no data are from real people.

    usage: python3 calibrate.py
"""

import haptic_retargeting as hrt

TRUTH = {"tactile_weight": 0.2, "bias_deg": 2.0}


def simulated() -> hrt.Person:
    return hrt.Person(1, tactile_weight=TRUTH["tactile_weight"], bias_deg=TRUTH["bias_deg"], tracker_noise_m=0.0005)


def main() -> None:
    with hrt.Session() as session, simulated() as person:
        plate_deg, frame = 0.0, 0
        with session.set_up(hrt.SetupFlag.CALIBRATION) as setup:
            person.begin(session)  # to do what the set-up asks for
            while not setup.over:
                frame += 1
                plate_deg = setup.update(person.move(frame * 11_111_111, plate_deg)).plate_orientation_deg
        result, profile = setup.result, session.profile
    print(f"{result.slides_used} simulated slides\n{'':24}truth   estimate (95 % interval)")
    for name, truth in TRUTH.items():
        estimate = getattr(result, name)
        shown = f"{estimate.value:.4g} ({estimate.lower:.4g} to {estimate.upper:.4g})" if estimate.known else "not known"
        print(f"{name:24}{truth:<7g} {shown}")
    print("profile:", profile)


main()

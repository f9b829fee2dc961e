"""A study in a few lines: how the result of a person's first and fifth reach depends on their tactile weight. The people are
simulated; no data are from real people.

    usage: python3 closed_loop.py
"""

import numpy as np

import haptic_retargeting as hrt

PEOPLE, REACHES, FRAMES = 20, 5, 900  # at most, at 90 Hz


def ended_deg(session: hrt.Session, person: hrt.Person) -> float:
    """Returns the bearing of the finger's end from the real target, seen from the start."""
    cylinder, cup = session.target("cylinder"), session.target("cup")
    person.begin(session, cup)
    command = hrt.Command()
    with session.reach(cylinder, cup) as reach:
        for frame in range(FRAMES):
            command = reach.update_sample(person.move(frame * 11_111_111, command.plate_orientation_deg))
            if command.flags & hrt.CommandFlag.ARRIVED:
                break
    return reach.summary.miss_deg


def main() -> None:
    print(f"{PEOPLE} simulated people a row: mean and standard deviation of where the hand ended beside the real target, degrees.\n"
          "share of touch   first reach      fifth reach")
    for tactile_weight in (0.15, 0.20, 0.25, 0.30):
        ends = np.zeros((PEOPLE, REACHES))
        for seed in range(PEOPLE):
            with hrt.Session() as session, hrt.Person(seed, tactile_weight=tactile_weight) as person:
                session.add_real("cylinder", direction_deg=-5)
                session.add_virtual("cup", direction_deg=5)
                ends[seed] = [ended_deg(session, person) for _ in range(REACHES)]
        cells = [f"{np.mean(column):+.2f} +- {np.std(column, ddof=1):.2f}" for column in (ends[:, 0], ends[:, -1])]
        print(f"{tactile_weight:14.2f}   {cells[0]}   {cells[1]}")


main()

#!/usr/bin/python3
"""Prints the same line as engine/people.gd, without an engine, and the true results of the reaches as hrt-study counts them."""
import hashlib
import math
import struct

import haptic_retargeting as hrt

numbers, on_target, truly = [], 0, 0
for seed in range(10):
    with hrt.Session() as session, hrt.Person(seed) as person:
        cylinder, cup = session.add_real("cylinder", direction_deg=-5), session.add_virtual("cup", direction_deg=5)
        for _ in range(10):
            person.begin(session, cup)
            command = hrt.Command()
            with session.reach(cylinder, cup) as reach:
                for frame in range(900):
                    command = reach.update_sample(person.move(frame * 11_111_111, command.plate_orientation_deg))
                    numbers.append(command.plate_orientation_deg)
                    if command.flags & hrt.CommandFlag.ARRIVED:
                        break
            numbers.append(reach.summary.miss_deg)
            on_target += abs(reach.summary.miss_deg) < 1.5
            right_m, _, back_m = person.state.position_m
            truly += abs(math.degrees(math.atan2(-right_m, 0.05 - back_m)) + 5) < 1.5
print(f"{on_target} of 100 reaches within 1.5 degrees, {hashlib.sha256(struct.pack(f'<{len(numbers)}d', *numbers)).hexdigest()}")
print(f"{truly} of them in truth")

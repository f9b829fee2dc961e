"""The reach that every host's sample runs (plugin/bindings/README.md): passes the recorded samples to a new session and
prints the hash of the resulting commands, which is the same on every host.

    usage: python3 reach.py RECORDING_CSV [PICTURE]
"""

import sys
from typing import Any

import haptic_retargeting as hrt


def fnv1a(commands: Any) -> int:
    """Computes FNV-1a over HRT_HASHED_FIELDS (recording.h), the fields of a command in their order, 8 bytes each."""
    value = 0xCBF29CE484222325
    for flags, *others in commands[hrt.Command.names()]:
        for byte in int(flags).to_bytes(8, "little") + b"".join(other.tobytes() for other in others):
            value = (value ^ byte) * 0x100000001B3 % 2**64
    return value


def main() -> None:
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    samples = hrt.read_recording(sys.argv[1]).reaches[0].samples
    with hrt.Session(
        horizon=20,
        guidance=hrt.Guidance.ARRIVAL,
        adaptation=hrt.Adaptation.REACH,
        plate_max_speed_deg_s=200,
        plate_max_acceleration_deg_s2=20_000,
        plate_latency_ns=30_000_000,
        plate_lower_stop_deg=-360,
        plate_upper_stop_deg=360,
    ) as session:
        cylinder = session.add_real("cylinder", direction_deg=-5)
        cup = session.add_virtual("cup", direction_deg=5)
        record = session.run_reach(cylinder, cup, samples)
    print(f"hash 0x{fnv1a(record.commands):016x}")
    print(f"updates {len(samples)}; ended {1000 * record.summary.distance_to_target_m:.1f} mm from the real target, "
          f"{abs(record.summary.miss_deg):.2f} deg off its bearing (simulated)")
    if len(sys.argv) == 3:
        from haptic_retargeting import plot

        plot.reach(record, "A simulated reach").savefig(sys.argv[2], dpi=110)


main()

"""Haptic retargeting by touch: a ridged plate under the user's finger turns so that the hand arrives at a real target
while the user perceives that it moves to a virtual one.

    import haptic_retargeting as hrt

    with hrt.Session(adaptation=hrt.Adaptation.REACH) as session:
        cylinder = session.add_real("cylinder", direction_deg=-5)
        cup = session.add_virtual("cup", direction_deg=5)
        record = session.run_reach(cylinder, cup, hrt.samples(time_ns, position_m=positions))

Units are in the names: metres, degrees, nanoseconds. Directions are measured from the plate's mid-line, which points
straight away from the user; they are positive counter-clockwise, seen from above. Plate coordinates: x right, y up, z
towards the user.

The C library is the file that the environment variable HRT_LIBRARY names, or that of the wheel, or that of the system.
"""

try:
    import numpy as _numpy  # noqa: F401
except ImportError as error:
    raise ImportError("haptic_retargeting needs numpy, 1.20 or later: pip install numpy, or python3-numpy of Debian") from error

from . import _abi
from ._abi import *
from ._library import Error, library_version
from .arrays import COMMAND, SAMPLE, commands, samples
from .person import Person
from .reach import Reach
from .record import ReachRecord, RunRecord, target_place, world_to_plate
from .recording import Recording, RecordingError, read_recording, replay
from .scene import Scene
from .session import Session, Target
from .setup import SetUp

__version__ = ".".join(str(number) for number in _abi.VERSION)

__all__ = [
    "COMMAND", "commands", "Error", "library_version", "Person", "Reach", "ReachRecord", "read_recording", "Recording",
    "RecordingError", "replay", "RunRecord", "SAMPLE", "samples", "Scene", "Session", "SetUp", "Target", "target_place",
    "world_to_plate",
]
__all__ += _abi.__all__

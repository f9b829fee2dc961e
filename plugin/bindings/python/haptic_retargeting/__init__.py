"""Haptic retargeting by touch: a ridged plate under the user's finger turns so that the hand arrives at a real target
while the user feels that it goes to a virtual one.

    import haptic_retargeting as hrt

    with hrt.Session(adaptation=hrt.Adaptation.REACH) as session:
        cylinder = session.add_real("cylinder", direction_deg=-5)
        cup = session.add_virtual("cup", direction_deg=5)
        record = session.run_reach(cylinder, cup, hrt.samples(time_ns, position_m=positions))

Metres, degrees and nanoseconds, as the names say. Directions are measured from the plate's mid-line, straight away
from the user, counter-clockwise positive seen from above. Plate coordinates: x right, y up, z towards the user.

The calls are those of the C library, which is found by the system's loader, or where HRT_LIBRARY says.
"""

from ._abi import (
    Adaptation, Authority, CalibrationConfig, CalibrationResult, Command, CommandFlag, Control, ErrorCode,
    Guidance, Interval, Place, ReachSummary, RecordingStatus, ReplayReport, Role, Sample, SampleFlag, SceneInfo,
    SceneTarget, SessionConfig, StateFlag, TargetConfig,
)
from ._abi import VERSION as _VERSION
from ._library import Error, library_version
from .arrays import COMMAND, SAMPLE, commands, samples
from .calibration import Calibration
from .reach import Reach
from .record import ReachRecord, Recording, RecordingError, read_recording, replay, target_place, world_to_plate
from .scene import Scene
from .session import Session, Target

__version__ = ".".join(str(number) for number in _VERSION)

__all__ = [
    "Adaptation", "Authority", "Calibration", "CalibrationConfig", "CalibrationResult", "COMMAND", "Command",
    "CommandFlag", "commands", "Control", "Error", "ErrorCode", "Guidance", "Interval", "library_version",
    "Place", "Reach", "ReachRecord", "ReachSummary", "read_recording", "Recording", "RecordingError",
    "RecordingStatus", "replay", "ReplayReport", "Role", "SAMPLE", "Sample", "SampleFlag", "samples", "Scene",
    "SceneInfo", "SceneTarget", "Session", "SessionConfig", "StateFlag", "Target", "target_place", "TargetConfig",
    "world_to_plate",
]

"""The device that turns the plate, driven by libhrt_plate: a plate with the line protocol, or a Dynamixel servo.

    with Plate("plate.json") as plate:
        plate.wait_until_ready()
        plate.set(30.0)
        print(plate.get().orientation_deg)
"""

from __future__ import annotations

import ctypes
import functools
import time
from typing import Any

from . import _abi, _plate_abi
from ._library import Closing, Error, load, renamed
from ._plate_abi import *

__all__ = ["Plate", *_plate_abi.__all__]


@functools.cache
def _library() -> ctypes.CDLL:
    """Returns libhrt_plate; the first call loads it."""
    return load("hrt_plate", "HRT_PLATE_LIBRARY", _plate_abi.FUNCTIONS)


def _check(result: int) -> None:
    if result != _abi.OK:
        raise Error(result, renamed(_library().hrt_plate_last_error(), _plate_abi.NAMES))


class Plate(Closing):
    """A plate. A thread of the library communicates with it, so calls do not wait, except wait_until_ready() and
    close(). close() stops the plate and restores the settings of its serial port within 0.5 s."""

    _check = staticmethod(_check)

    def __init__(self, device: str, host_timeout_s: float = 0.3, homing: PlateHoming = PlateHoming.REFUSED) -> None:
        """Starts to open a plate: "serial:/dev/ttyACM0", "dynamixel:/dev/ttyUSB0?id=1", or the file that `hrt-plate
        commission` writes. The plate stops if there is no call for `host_timeout_s` (0.05 to 10)."""
        self._handle = _plate_abi.PlateHandle()
        options = _plate_abi.PlateOptions(homing=homing, host_timeout_ns=round(host_timeout_s * 1e9))
        _check(_library().hrt_plate_open(device.encode(), ctypes.byref(options), ctypes.byref(self._handle)))
        self._own(self._handle, _library().hrt_plate_close)

    def set(self, orientation_deg: float) -> None:
        """Turns the plate to the nearest orientation within its stops that has the same ridges as the given one, or
        else to the nearest stop. Ridges repeat every 180 degrees."""
        _check(_library().hrt_plate_set(self._handle, orientation_deg))

    def stop(self) -> None:
        """Stops the plate, which holds its present orientation."""
        _check(_library().hrt_plate_stop(self._handle))

    def get(self) -> PlateReport:
        """Returns state, orientation and properties of the plate."""
        report = PlateReport()
        _check(_library().hrt_plate_get(self._handle, ctypes.byref(report)))
        return report

    def session_fields(self) -> dict[str, Any]:
        """Returns speed, acceleration, latency and stops of a ready plate, for Session() or configure(). Stops less
        than 180 degrees apart, which a session cannot have, become 0, as for a plate that turns freely."""
        report = self.get()
        has_stops = report.upper_stop_deg - report.lower_stop_deg >= 180.0
        return {"plate_max_speed_deg_s": report.max_speed_deg_s, "plate_latency_ns": report.latency_ns,
                "plate_max_acceleration_deg_s2": report.max_acceleration_deg_s2,
                "plate_lower_stop_deg": report.lower_stop_deg if has_stops else 0.0,
                "plate_upper_stop_deg": report.upper_stop_deg if has_stops else 0.0}

    def wait_until_ready(self) -> PlateReport:
        """Waits until the plate is ready. Raises RuntimeError with the reason if it has failed."""
        while (report := self.get()).state == PlateState.OPENING:
            time.sleep(0.01)
        if report.state == PlateState.FAILED:
            raise RuntimeError(report.message)
        return report

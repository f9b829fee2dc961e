"""Tests haptic_retargeting.plate with the plate's firmware on an emulated board; run by with_plate."""

import os
import time
from collections.abc import Callable

import pytest

from haptic_retargeting import Error, Session
from haptic_retargeting.plate import Plate, PlateFault, PlateReport, PlateReportFlag


def eventually(plate: Plate, wanted: Callable[[PlateReport], bool]) -> PlateReport:
    """Waits up to 30 s for a report that fulfils a condition, and returns it."""
    give_up = time.monotonic() + 30.0
    while not wanted(report := plate.get()) and time.monotonic() < give_up:
        time.sleep(0.01)
    assert wanted(report), f"{report.state} at {report.orientation_deg} degrees, {report.message!r}"
    return report


def test_opens_turns_and_stops() -> None:
    with Plate(os.environ["HRT_PLATE_DEVICE"], host_timeout_s=10) as plate:
        report = plate.wait_until_ready()
        assert report.description == "protocol 2, firmware 1.1.0, serial number 000000"
        assert report.fault == PlateFault.NONE and report.lower_stop_deg == -90.0
        with Session(**plate.session_fields()) as session:
            assert session.config.plate_lower_stop_deg == -90.0
            assert session.config.plate_latency_ns > 30e6
        plate.set(210.0)  # equivalent to 30
        assert PlateReportFlag.COMMANDED in eventually(plate, lambda report: report.orientation_deg == 30.0).flags
        plate.stop()
        eventually(plate, lambda report: PlateReportFlag.COMMANDED not in report.flags)


def test_a_commissioned_plate_reports_its_measurements() -> None:
    with Plate(os.environ["HRT_PLATE_FILE"], host_timeout_s=10) as plate:
        assert PlateReportFlag.COMMISSIONED in plate.wait_until_ready().flags
        fields = plate.session_fields()
        assert fields["plate_max_speed_deg_s"] == 123.0 and fields["plate_max_acceleration_deg_s2"] == 5000.0 and 4e6 < fields["plate_latency_ns"] < 30e6


def test_failures_raise_with_their_reason() -> None:
    with Plate("serial:/nonexistent") as plate, pytest.raises(RuntimeError, match="at /nonexistent cannot be opened"):
        plate.wait_until_ready()
    with pytest.raises(Error, match='Plate: device is of kind "usb"'):
        Plate("usb:0")

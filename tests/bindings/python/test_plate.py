"""haptic_retargeting.plate against a plate at the other end of a pseudo-terminal."""

import binascii
import os
import pty
import select
import threading
import time
import tty
from collections.abc import Iterator

import pytest

from haptic_retargeting import Error
from haptic_retargeting.plate import Plate, PlateFault, PlateReportFlag, PlateState


class FakePlate(threading.Thread):
    """Answers as samples/plate/protocol.md says, and is at once where it is sent."""

    def __init__(self) -> None:
        super().__init__(daemon=True)
        self.host, self.end = pty.openpty()
        tty.setraw(self.host)
        self.device = os.ttyname(self.end)
        self.place, self.sequence, self.ended = "+000.00", "00000", False
        self.heard: list[str] = []
        self.start()

    def say(self, body: str) -> None:
        os.write(self.host, f"{body}*{binascii.crc_hqx(body.encode(), 0xFFFF):04X}\n".encode())

    def run(self) -> None:
        unread = b""
        while not self.ended:
            if select.select([self.host], [], [], 0.01)[0]:
                unread += os.read(self.host, 256)
            *lines, unread = unread.split(b"\n")
            for line in lines:
                self.hear(line.decode().partition("*")[0].split(" "))
            if self.heard:
                self.say(f"AT {self.place} {self.sequence}")

    def hear(self, words: list[str]) -> None:
        self.heard.append(words[0])
        if words[0] == "HELLO":
            self.say("PLATE 2 -90.00 90.00 400.00 10.00 measured")
        elif words[0] == "INFO":
            self.say("INFO 0.2 000009")
        else:
            self.sequence = words[-1]
        if words[0] == "SET":
            self.place = words[1]


@pytest.fixture
def device() -> Iterator[FakePlate]:
    fake = FakePlate()
    yield fake
    fake.ended = True
    fake.join()
    os.close(fake.host)
    os.close(fake.end)


def test_opens_turns_and_stops(device: FakePlate) -> None:
    with Plate("serial:" + device.device) as plate:
        assert plate.get().state in (PlateState.OPENING, PlateState.READY)
        report = plate.wait_until_ready()
        assert report.description == b"protocol 2, firmware 0.2, serial number 000009"
        assert report.fault == PlateFault.NONE and report.lower_stop_deg == -90.0
        plate.set(210.0)  # feels like 30
        give_up = time.monotonic() + 10.0
        while plate.get().orientation_deg != 30.0 and time.monotonic() < give_up:
            time.sleep(0.01)
        report = plate.get()
        assert report.orientation_deg == 30.0 and PlateReportFlag.COMMANDED in report.flags
        plate.stop()
    give_up = time.monotonic() + 10.0
    while device.heard[-1] != "STOP" and time.monotonic() < give_up:
        time.sleep(0.01)
    assert device.heard[-1] == "STOP"


def test_failures_have_their_reason() -> None:
    with Plate("serial:/nonexistent") as plate, pytest.raises(RuntimeError, match="at /nonexistent cannot be opened"):
        plate.wait_until_ready()
    with pytest.raises(Error, match='hrt_plate_open: device is of kind "usb"'):
        Plate("usb:0")

from pathlib import Path

import numpy as np
import pytest
from conftest import BINDINGS
from matplotlib.backends.backend_agg import FigureCanvasAgg

import haptic_retargeting as hrt
from haptic_retargeting import plot

REACH = BINDINGS / "reach.csv"


def test_recorded_reach_is_read_bit_for_bit(session: hrt.Session, straight: np.ndarray, tmp_path: Path) -> None:
    straight["flags"][::7] = 0
    with session.recording(tmp_path / "a.csv") as status:
        ran = session.run_reach(session.target("cylinder"), session.target("cup"), straight)
    assert (status.rows_written, status.rows_lost) == (273, 0)
    recording = hrt.read_recording(tmp_path / "a.csv")
    (read,) = recording.reaches
    assert recording.complete and [t.name for t in recording.targets] == ["cylinder", "cup"]
    assert read.commands.tobytes() == ran.commands.tobytes()
    seen = straight["flags"] != 0
    assert read.samples[seen].tobytes() == straight[seen].tobytes()
    assert np.isnan(read.position_m[~seen]).all()
    assert (read.real_direction_deg, read.virtual_direction_deg, read.real_distance_m) == (-5, 5, 0.1)
    assert np.allclose(read.start_position_m, (0, 0, 0.05))
    assert read.summary == ran.summary and read.final_bearing_deg == ran.final_bearing_deg
    assert read.config == ran.config
    report = hrt.replay(tmp_path / "a.csv")
    assert (report.complete, report.first_different_line, report.rows) == (1, 0, 273)


def test_checked_in_recordings_are_read() -> None:
    (reach,) = hrt.read_recording(REACH).reaches
    assert len(reach.samples) == 167
    summary = reach.summary
    assert summary is not None and reach.commands["bearing_deg"][-1] == summary.bearing_deg
    assert summary.samples == 167 and summary.dropped_samples == 16
    assert summary.miss_deg == reach.commands["predicted_miss_deg"][-1] and summary.duration_s > 1


def with_row(tmp_path: Path, result: str, cells: dict[str, str]) -> Path:
    """Writes reach.csv with an additional row "update" before the first one. Cells that are not given are empty."""
    lines = REACH.read_text().splitlines(keepends=True)
    header = next(line for line in lines if not line.startswith("#")).rstrip("\n").split(",")
    row = ["update", result, *(cells.get(name, "") for name in header[2:])]
    at = next(i for i, line in enumerate(lines) if line.startswith("update"))
    path = tmp_path / "refused.csv"
    path.write_text("".join([*lines[:at], ",".join(row) + "\n", *lines[at:]]))
    return path


def test_calls_that_were_refused_have_no_command(tmp_path: Path) -> None:
    (reach,) = hrt.read_recording(with_row(tmp_path, "-7", {"time_ns": "0", "sample_flags": "0"})).reaches
    refused = reach.results != 0
    assert refused.sum() == 1 and np.isnan(reach.commands["plate_orientation_deg"][refused]).all()


def test_world_positions_are_converted_to_plate_coordinates() -> None:
    # A plate at (1, 2, 3), rotated by 90 degrees about y: its x axis is the world's -z, its z axis the world's x.
    turned = (0, np.sqrt(0.5), 0, np.sqrt(0.5))
    assert hrt.world_to_plate((1, 2, 2), (1, 2, 3), turned) == pytest.approx((1, 0, 0))
    assert hrt.world_to_plate((2, 2.5, 3), (1, 2, 3), turned, plate_scale=0.5) == pytest.approx((0, 1, 2))
    config = hrt.SessionConfig(plate_position_m=(1, 2, 3), plate_rotation=turned, plate_scale=2, fingertip_offset_m=(0, 0, -0.1))
    target = hrt.TargetConfig(place=hrt.Place.WORLD_POSITION, position_m=(1.0, 2, 2.8))
    assert hrt.target_place(target, config)[1] == pytest.approx(np.hypot(0.1, 0.05))
    # The joint is rotated by 90 degrees about y, so that the skin is 10 cm along the world's -x from it.
    sample = hrt.Sample(flags=hrt.SampleFlag.WORLD_POSITION | hrt.SampleFlag.JOINT_ROTATION, finger_position_m=(1, 2, 2.8),
                        joint_rotation=turned)
    record = hrt.ReachRecord(config, 0, 0, 0.1, np.zeros(3), np.frombuffer(sample, hrt.SAMPLE), hrt.commands(1), np.zeros(1, np.int32))
    assert record.position_m[0] == pytest.approx((0.1, 0, -0.05))


@pytest.mark.parametrize(("old", "new", "text"), [
    ("# haptic", "# some", "line 1: not a recording"),
    ("call,result", "call,outcome", "line 7: the column result is missing"),
    ("begin,0", "start,0", "line 12: the row's call is 'start'"),
    (",0,-5,5,0.1,", ",0,-5,,0.1,", "line 12: virtual_direction_deg is missing"),
    ("update,0,200028000", "update,0,soon", "line 22: .*'soon'"),
    ("update,0,200028000", "update,0,9" + 20 * "9", "line 22: time_ns is 9+, which does not fit into int64"),
    ("update,0,200028000,", "update,0,", "line 22: the row has 69 columns; 70"),
    ('"horizon":20', '"horizon":"twenty"', "line 8"),
    ('"horizon":20', '"horizon":-3', "line 8: SessionConfig.horizon is -3: a number from 0 to"),
    ("# config {", "# config [", "line 8"),
    ("# config {", "# setup {", 'line 12: the line "# config" is missing before this row'),
])
def test_files_that_are_not_recordings_are_refused_with_the_line(tmp_path: Path, old: str, new: str, text: str) -> None:
    good = REACH.read_text()
    assert old in good
    (tmp_path / "bad.csv").write_text(good.replace(old, new, 1))
    with pytest.raises(hrt.RecordingError, match=rf"bad.csv, {text}"):
        hrt.read_recording(tmp_path / "bad.csv")


def test_recording_cut_off_anywhere_is_incomplete_or_refused(tmp_path: Path) -> None:
    text = REACH.read_text()
    path = tmp_path / "cut.csv"
    for size in (*range(0, 4000, 97), *range(4000, len(text) - 1, 4001)):
        path.write_text(text[:size])
        try:
            assert not hrt.read_recording(path).complete
        except hrt.RecordingError:
            assert size < text.index("\nbegin")


def test_bytes_that_are_not_text_are_refused(tmp_path: Path) -> None:
    (tmp_path / "bytes.csv").write_bytes(b"\xff\xfe\x00\n")
    with pytest.raises(hrt.RecordingError, match="not text"):
        hrt.read_recording(tmp_path / "bytes.csv")


def test_a_run_faster_than_the_disk_loses_no_calls(session: hrt.Session, tmp_path: Path) -> None:
    n = 60_000
    samples = hrt.samples(np.arange(n) * 1_000_000, direction_deg=0)
    with session.recording(tmp_path / "long.csv") as status:
        session.run_reach(session.target("cylinder"), session.target("cup"), samples)
        for _ in range(50):
            session.run_reach(session.target("cylinder"), session.target("cup"), samples[:500])
    assert (status.rows_written, status.rows_lost) == (n + 2 + 50 * 502, 0)


def test_recording_may_end_before_the_reach(session: hrt.Session, tmp_path: Path) -> None:
    with session.recording(tmp_path / "part.csv"):
        reach = session.reach(session.target("cylinder"), session.target("cup"))
        reach.run(hrt.samples(np.arange(100), direction_deg=0))
    reach.run(hrt.samples(np.arange(100, 5000), direction_deg=0))
    assert reach.end().samples == 5000
    assert len(hrt.read_recording(tmp_path / "part.csv").reaches[0].samples) == 100


def test_a_reach_that_starts_at_the_finger_has_its_first_position_as_start(
        session: hrt.Session, straight: np.ndarray, tmp_path: Path) -> None:
    straight["flags"][:5] = 0
    with session.recording(tmp_path / "started.csv"):
        with session.reach(session.target("cylinder"), session.target("cup"), start_at_finger=True) as reach:
            reach.run(straight)
    (read,) = hrt.read_recording(tmp_path / "started.csv").reaches
    start_m = straight["finger_position_m"][5]
    assert read.start_position_m == pytest.approx(start_m)
    # A target given by a direction is 10 cm from the configured start, which is 5 cm towards the user.
    away_m = 0.1 * np.cos(np.radians(5)) - (0.05 - start_m[2])
    assert read.real_direction_deg == pytest.approx(-np.degrees(np.arctan2(0.1 * np.sin(np.radians(5)), away_m)), abs=0.2)
    assert hrt.replay(tmp_path / "started.csv").first_different_line == 0


def test_picture_shows_finger_targets_and_angles() -> None:
    (record,) = hrt.read_recording(REACH).reaches
    figure = plot.reach(record, "title")
    above, time, plate = figure.axes
    finger = next(line for line in above.lines if line.get_label() == "finger, as tracked")
    assert np.array_equal(finger.get_xdata(), 1000 * record.position_m[:, 0], equal_nan=True)
    assert np.array_equal(finger.get_ydata(), -1000 * record.position_m[:, 2], equal_nan=True)
    real = next(line for line in above.lines if str(line.get_label()).startswith("real target"))
    # 100 mm from the start, 5 degrees to the right.
    assert real.get_xdata() == pytest.approx(100 * np.sin(np.radians(5)))
    assert real.get_ydata() == pytest.approx(-50 + 100 * np.cos(np.radians(5)))
    labels = [line.get_label() for line in (*time.lines, *plate.lines)]
    assert "plate, commanded" in labels and "felt, as the model predicts" in labels
    # The picture shows the bearing of the finger, not the direction of its motion, which differs at the end.
    bearing = next(line for line in time.lines if line.get_label() == "finger").get_ydata()
    assert record.summary is not None and bearing[-1] - record.real_direction_deg == pytest.approx(record.summary.miss_deg, abs=0.5)
    canvas = FigureCanvasAgg(figure)
    canvas.draw()
    pixels = np.asarray(canvas.buffer_rgba())[..., :3].reshape(-1, 3)
    for colour in ((0x00, 0x72, 0xB2), (0xD5, 0x5E, 0x00)):
        assert (np.abs(pixels - np.array(colour)).max(axis=1) < 8).sum() > 300


def test_felt_path_equals_that_of_the_simulated_person() -> None:
    with hrt.Session() as session, hrt.Person(1, tracker_noise_m=1e-6) as person:
        cylinder, cup = session.add_real(direction_deg=-5), session.add_virtual(direction_deg=5)
        for _ in range(3):  # until the controller has learnt this person's parameters
            person.begin(session, cup)
            samples, commands, plate_deg = hrt.samples(np.arange(220) * 11_111_111), hrt.commands(220), 0.0
            with session.reach(cylinder, cup) as reach:
                for frame in range(220):
                    samples[frame] = np.frombuffer(person.move(frame * 11_111_111, plate_deg), hrt.SAMPLE)[0]
                    reach.run(samples[frame:frame + 1], commands[frame:frame + 1])
                    plate_deg = commands["plate_orientation_deg"][frame]
        record = hrt.ReachRecord(session.config, -5, 5, 0.1, np.array((0, 0, 0.05)), samples, commands, np.zeros(220, np.int32))
        hand, felt = record.position_m[-1], record.felt_position_m[-1]
        assert felt == pytest.approx(person.state.felt_position_m, abs=0.006) and hand[0] - felt[0] > 0.012
        assert record.bearing_deg(felt) == pytest.approx(5, abs=3) and np.isnan(record.bearing_deg([0, 0, 0.06]))


def test_picture_of_a_reach_without_positions_is_drawn(session: hrt.Session) -> None:
    samples = hrt.samples(np.arange(3) * 100_000_000, direction_deg=[0, np.nan, 1])
    record = session.run_reach(session.target("cylinder"), session.target("cup"), samples)
    FigureCanvasAgg(plot.reach(record)).draw()

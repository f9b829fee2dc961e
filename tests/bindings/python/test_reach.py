import ctypes
import re

import numpy as np
import pytest

import haptic_retargeting as hrt


def test_arrays_give_the_bits_of_single_steps(session: hrt.Session, straight: np.ndarray) -> None:
    real, virtual = session.target("cylinder"), session.target("cup")
    record = session.run_reach(real, virtual, straight, plate_orientation_deg=0)
    with session.reach(real, virtual, plate_orientation_deg=0) as reach:
        for sample, expected in zip(straight, record.commands):
            command = reach.update(sample["time_ns"], position_m=sample["finger_position_m"])
            assert bytes(command) == expected.tobytes()
    out = hrt.commands(len(straight))
    with session.reach(real, virtual, plate_orientation_deg=0) as again:
        assert again.run(straight, out) is out and out.tobytes() == record.commands.tobytes()
    assert record.summary == reach.summary == again.summary
    assert record.summary.steps == 30
    assert record.final_bearing_deg == record.summary.bearing_deg
    assert np.array_equal(record.position_m, straight["finger_position_m"])


def test_a_returned_command_does_not_change_later(session: hrt.Session) -> None:
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        first = reach.update(0, direction_deg=0)
        before = bytes(first)
        reach.update(100_000_000, direction_deg=3)
        assert bytes(first) == before


def test_an_error_in_an_array_names_the_row_and_keeps_previous_commands(session: hrt.Session, straight: np.ndarray) -> None:
    straight["time_ns"][100] = -1
    out = hrt.commands(len(straight))
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        with pytest.raises(hrt.Error, match=r"samples\[100\].*time_ns") as caught:
            reach.run(straight, out)
    assert caught.value.code is hrt.ErrorCode.TIME_REVERSED
    assert out["paper_step"][99] > 0 and out["paper_step"][100] == 0


def test_exception_within_a_reach_cancels_it(session: hrt.Session, straight: np.ndarray) -> None:
    real, virtual = session.target("cylinder"), session.target("cup")
    with pytest.raises(ZeroDivisionError):
        with session.reach(real, virtual) as reach:
            reach.run(straight)
            1 / 0
    with pytest.raises(RuntimeError, match="was cancelled"):
        reach.summary
    with pytest.raises(ZeroDivisionError):
        with session.reach(real, virtual):
            session.close()
            1 / 0


def test_session_cancels_what_is_in_progress(session: hrt.Session) -> None:
    real, virtual = session.target("cylinder"), session.target("cup")
    session.reach(real, virtual)  # without keeping the object
    session.cancel()
    with session.reach(real, virtual) as reach:
        with pytest.raises(hrt.Error, match="Session.configure"):
            session.configure(horizon=4)
        session.cancel()
    with pytest.raises(RuntimeError, match="was cancelled"):
        reach.summary
    with session.set_up(hrt.SetupFlag.REGISTRATION) as setup:
        session.cancel()
    assert setup.over and session.state == hrt.StateFlag.READY
    with pytest.raises(hrt.Error, match="Reach.cancel") as caught:
        session.cancel()
    assert caught.value.code is hrt.ErrorCode.WRONG_STATE


@pytest.mark.parametrize("wrong", [
    np.zeros(3), np.zeros((3, 3), hrt.SAMPLE), np.zeros(6, hrt.SAMPLE)[::2], np.zeros(3, hrt.COMMAND)])
def test_other_arrays_are_refused(session: hrt.Session, wrong: np.ndarray) -> None:
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        with pytest.raises(TypeError, match="one contiguous row"):
            reach.run(wrong)
        with pytest.raises(ValueError, match="2 rows"):
            reach.run(hrt.samples([0, 1]), hrt.commands(3))


@pytest.mark.parametrize("size", [0, 10**9])
def test_rows_of_another_size_are_refused(session: hrt.Session, straight: np.ndarray, size: int) -> None:
    straight["struct_size"][3] = size
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        with pytest.raises(ValueError, match="struct_size"):
            reach.run(straight)


def test_no_samples_are_refused(session: hrt.Session) -> None:
    with pytest.raises(hrt.Error, match="has had no sample"):
        session.run_reach(session.target("cylinder"), session.target("cup"), np.zeros(0, hrt.SAMPLE))
    assert session.state == hrt.StateFlag.READY
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        assert len(reach.run(np.zeros(0, hrt.SAMPLE))) == 0
        with pytest.raises(hrt.Error, match="has had no sample"):
            reach.end()
    with pytest.raises(RuntimeError, match="was cancelled"):
        _ = reach.summary


def test_record_has_a_readable_repr(session: hrt.Session, straight: np.ndarray) -> None:
    straight["flags"][50:80] = 0
    record = session.run_reach(session.target("cylinder"), session.target("cup"), straight)
    assert re.fullmatch(r"<RunRecord: 271 samples in 3\.00 s, real target -5\.00 deg, virtual \+5\.00 deg, "
                        r"final bearing [-+]\d\.\d\d deg>", repr(record))


def test_samples_are_made_of_columns() -> None:
    made = hrt.samples([0, 1, 2], position_m=[[1, 2, 3], [np.nan, 0, 0], [4, 5, 6]], plate_orientation_deg=[np.nan, 7, 8],
                       lifted=[False, False, True])
    position, plate, lifted = (int(f) for f in (hrt.SampleFlag.PLATE_POSITION, hrt.SampleFlag.PLATE_ORIENTATION,
                                                hrt.SampleFlag.LIFTED))
    assert list(made["flags"]) == [position, plate, position | plate | lifted]
    assert made["finger_position_m"].tolist() == [[1, 2, 3], [0, 0, 0], [4, 5, 6]]
    assert made["plate_orientation_deg"].tolist() == [0, 7, 8]
    assert set(made["struct_size"]) == {ctypes.sizeof(hrt.Sample)}
    assert hrt.samples([5], direction_deg=3)["flags"][0] == hrt.SampleFlag.DIRECTION


def test_unknown_numbers_are_dropouts_in_every_call(session: hrt.Session, straight: np.ndarray) -> None:
    real, virtual, nan = session.target("cylinder"), session.target("cup"), np.nan
    straight["finger_position_m"][100:130, 0] = nan  # after samples(), which would have cleared the flags
    record = session.run_reach(real, virtual, straight, plate_orientation_deg=0)
    expected = hrt.samples(straight["time_ns"], position_m=straight["finger_position_m"])
    assert record.commands.tobytes() == session.run_reach(real, virtual, expected, plate_orientation_deg=0).commands.tobytes()
    assert (straight["flags"] == hrt.SampleFlag.PLATE_POSITION).all()
    sample = hrt.Sample(flags=hrt.SampleFlag.WORLD_POSITION | hrt.SampleFlag.PLATE_ORIENTATION, time_ns=5)
    sample.plate_orientation_deg = nan
    sample.finger_position_m = np.ma.masked_array([0, 0, 0.05], [0, 0, 1])
    with session.reach(real, virtual) as reach:
        reach.update(0, position_m=(nan, 0, 0.05))
        reach.update(1, direction_deg=nan, plate_orientation_deg=nan)
        reach.update_sample(sample)
        sample.plate_rotation[0] = nan  # a field that is not read
        reach.update_sample(sample)
    assert reach.summary.dropped_samples == reach.summary.samples == 4 and np.isnan(sample.finger_position_m[2])
    with session.set_up(hrt.SetupFlag.REGISTRATION) as setup:
        assert setup.update(sample).instruction == hrt.Step.TOUCH_MARK


def test_masked_columns_are_dropouts() -> None:
    masked = np.ma.masked_array([[0, 0, 0.05], [9, 9, 9]], [[False] * 3, [False, True, False]])
    made = hrt.samples([0, 1], position_m=masked, plate_orientation_deg=np.ma.masked_array([7, 8], [True, False]),
                       lifted=np.ma.masked_array([True, True], [True, False]))
    position, plate, lifted = hrt.SampleFlag.PLATE_POSITION, hrt.SampleFlag.PLATE_ORIENTATION, hrt.SampleFlag.LIFTED
    assert list(made["flags"]) == [int(position), int(plate | lifted)]
    with pytest.raises(ValueError, match="time_ns has masked numbers"):
        hrt.samples(np.ma.masked_array([0, 1], [False, True]), direction_deg=0)


def test_wrong_columns_are_refused() -> None:
    for error, text, columns in ((ValueError, "whole numbers", {"time_ns": [0.5, 1.0]}),
                                 (ValueError, r"finger_position_m must have the shape \(2, 3\)", {"position_m": [[0, 0, 0]]}),
                                 (ValueError, "finger_direction_deg", {"direction_deg": [1, 2, 3]}),
                                 (ValueError, r"lifted must have the shape \(2,\)", {"lifted": [True]}),
                                 (TypeError, "finger_position_m must be numbers", {"position_m": "here"})):
        with pytest.raises(error, match=text):
            hrt.samples(**{"time_ns": [0, 1], **columns})


def test_values_that_are_not_arrays_are_refused(session: hrt.Session) -> None:
    with session.reach(session.target("cylinder"), session.target("cup")) as reach:
        with pytest.raises(TypeError, match="samples is a list: an array is needed"):
            reach.run([1, 2])
        with pytest.raises(TypeError, match="Sample.time_ns is 0.5: a whole number"):
            reach.update(0.5)
        with pytest.raises(RuntimeError, match="has not ended"):
            reach.summary


def test_a_reach_is_retargeted_and_cancelled(session: hrt.Session, straight: np.ndarray) -> None:
    real, virtual = session.target("cylinder"), session.target("cup")
    other = session.add_real("other", direction_deg=0, distance_m=0.08)
    (assigned,) = session.assign([virtual], [real, other], exclusive=True)
    assert assigned.real_target == other and assigned.real_target.name == "other" and assigned.virtual_target == virtual
    gap = session.gap(assigned.real_target, virtual)
    assert gap == assigned and "real_target=<Target 'other', real" in repr(gap)
    assert session.assign([virtual], [session.add_real(direction_deg=80)])[0].real_target is None
    virtual.configure(served_by=gap.real_target)
    assert virtual.config.served_by == other and real.config.served_by is None
    with session.reach(real, virtual, start_at_finger=True, duration_s=3) as reach:
        assert session.state == hrt.StateFlag.REACHING
        reach.run(straight[:100])
        reach.retarget(other, virtual)
        reach.cancel()
    with pytest.raises(RuntimeError, match="cancelled"):
        reach.summary
    assert session.state == hrt.StateFlag.READY


def test_a_simulated_person_refuses_what_it_cannot_do() -> None:
    with hrt.Session() as session, hrt.Person(7, tactile_weight=0.2) as person:
        with pytest.raises(hrt.Error, match=r"Person.move: .* call Person.begin\(\) with a virtual target first"):
            person.move(0, 0.0)
    with pytest.raises(hrt.Error, match="duration_s is 0.1"):
        hrt.Person(duration_s=0.1)

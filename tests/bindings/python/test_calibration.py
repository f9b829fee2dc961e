"""Calibration: slides whose answer is known by construction, and slides with too little data."""

import re
import runpy
from pathlib import Path

import numpy as np
import pytest
from conftest import BINDINGS

import haptic_retargeting as hrt


def slide(plate_deg: float, weight: float = 0.15, bias_deg: float = 2.0, seed: int = 0) -> np.ndarray:
    """A slide along the line on which a person without noise settles: P = (bias - w T) / (1 - w)."""
    random = np.random.default_rng([seed, round(plate_deg) + 90])
    angle = np.radians((bias_deg - weight * plate_deg) / (1 - weight))
    time_ns = np.arange(320) * 11_111_111
    away = np.clip(time_ns * 1e-9 - 0.5, 0, 3) * 0.1 / 3
    position = np.column_stack((-away * np.sin(angle), 0 * away, 0.05 - away * np.cos(angle)))
    position[:, [0, 2]] += 0.0003 * random.standard_normal((320, 2))
    return hrt.samples(time_ns, position_m=position)


def test_share_of_touch_and_bias_are_those_of_the_line() -> None:
    with hrt.Session() as session, hrt.Calibration(session) as calibration:
        for seed, plate_deg in enumerate((-60, -30, 0, 30, 60) * 3):
            calibration.add_trial(plate_deg, slide(plate_deg, seed=seed))
        result = calibration.solve()
        assert (result.trials, result.trials_used) == (15, 15)
        assert result.tactile_weight.value == pytest.approx(0.15, abs=0.003)
        assert result.bias_deg.value == pytest.approx(2.0, abs=0.1)
        assert result.tracker_noise_m.value == pytest.approx(0.0003, rel=0.1)
        session.apply_calibration(result)
        assert session.config.tactile_weight == result.tactile_weight.value
        assert session.profile["bias_deg"] == result.bias_deg.value


def test_results_are_compared_recorded_and_kept(tmp_path: Path) -> None:
    path, results = tmp_path / "slides.csv", []
    with hrt.Session() as session, session.recording(path):
        for weight in (0.15, 0.2):
            with hrt.Calibration(session, lower_plate_deg=-60, upper_plate_deg=60) as calibration:
                plate_deg, enough = calibration.next_angle()
                assert -60 <= plate_deg <= 60 and not enough
                for seed, plate_deg in enumerate((-60, -40, -20, 0, 20, 40, 60) * 2):
                    calibration.add_trial(plate_deg, slide(plate_deg, weight, seed=seed + 20 * len(results)))
                results.append(calibration.solve())
                assert calibration.residual(13).plate_deg == 60
                with pytest.raises(hrt.Error):
                    calibration.residual(14)
        session.set_conditions(plate="desk 1", tracker="Ultraleap", time_s=1_767_225_600)
        session.apply_calibration(results[0])
        assert session.profile["plate"] == "desk 1"
        session.set_conditions(plate="desk 2")
        assert session.conditions.differing == hrt.ConditionFlag.PLATE and session.conditions.plate == b"desk 1"
    change = hrt.compare_calibrations(*results)
    assert change.differing & hrt.DiffersFlag.TACTILE_WEIGHT and change.tactile_weight.value == pytest.approx(0.05, abs=0.01)
    assert hrt.read_recording(path).reaches == []
    report = hrt.replay(path)
    assert report.complete and report.first_different_line == 0 and report.rows > 2 * 14 * 300


def test_slides_over_one_orientation_are_refused() -> None:
    with hrt.Session() as session, hrt.Calibration(session) as calibration:
        for seed in range(12):
            calibration.add_trial(30, slide(30, seed=seed))
        with pytest.raises(hrt.Error, match="hrt_calibration_solve.*angles") as caught:
            calibration.solve()
        assert caught.value.code is hrt.ErrorCode.INSUFFICIENT_DATA


def test_bad_sample_is_named_and_its_trial_forgotten() -> None:
    with hrt.Session() as session, hrt.Calibration(session, max_trials=10) as calibration:
        bad = slide(0)
        bad["time_ns"][7] = -1
        with pytest.raises(hrt.Error, match=r"samples\[7\].*time_ns") as caught:
            calibration.add_trial(0, bad)
        assert caught.value.code is hrt.ErrorCode.TIME_REVERSED
        for _ in range(10):
            calibration.add_trial(0, slide(0))
        with pytest.raises(hrt.Error) as caught:
            calibration.add_trial(0, slide(0))
        assert caught.value.code is hrt.ErrorCode.LIMIT_REACHED
        with pytest.raises(TypeError, match="one contiguous row"):
            calibration.add_trial(0, np.zeros(4))


def test_example_finds_the_simulated_person(capsys: pytest.CaptureFixture[str]) -> None:
    runpy.run_path(str(BINDINGS / "python/examples/calibrate.py"))
    rows = re.findall(r"^(\w+) +(\S+) +(\S+) \((\S+) to (\S+)\)$", capsys.readouterr().out, re.M)
    assert {row[0] for row in rows} >= {"tactile_weight", "bias_deg", "tracker_noise_m"}
    for name, truth, value, lower, upper in rows:
        # Each interval misses 1 time in 20; twice as wide, hardly ever.
        assert abs(float(value) - float(truth)) <= float(upper) - float(lower), name

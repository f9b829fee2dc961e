from pathlib import Path

import pytest

import haptic_retargeting as hrt


def test_simulated_person_is_calibrated_by_the_loop(tmp_path: Path) -> None:
    path = tmp_path / "slides.csv"
    with hrt.Session() as session, hrt.Person(1, tactile_weight=0.2, tracker_noise_m=0.0005) as person, session.recording(path):
        session.set_conditions(plate="desk 1", tracker="Ultraleap", time_s=1_767_225_600)
        plate_deg, frame, texts = 0.0, 0, set()
        with session.set_up(hrt.SetupFlag.CALIBRATION) as setup:
            person.begin(session)
            while not setup.over and frame < 40_000:
                frame += 1
                step = setup.update(person.move(frame * 11_111_111, plate_deg))
                plate_deg = step.plate_orientation_deg
                texts.add(step.text)
        result = setup.result
        assert setup.over and result.done == hrt.SetupFlag.CALIBRATION and 16 <= result.slides <= 40
        assert result.tactile_weight.lower - 0.01 < 0.2 < result.tactile_weight.upper + 0.01
        assert session.config.tactile_weight == result.tactile_weight.value
        assert "Put your finger on the start and let it rest." in texts
        residual = setup.residual(result.slides_used - 1)
        assert residual.residual_deg == pytest.approx(residual.direction_deg - residual.fitted_deg)
        with pytest.raises(hrt.Error, match="slide is 200"):
            setup.residual(200)
        assert session.profile["plate"] == "desk 1"
        session.set_conditions(plate="desk 2")
        assert session.conditions.differing == hrt.ConditionFlag.PLATE and session.conditions.plate == "desk 1"
        session.new_person()
        assert session.config.tactile_weight == 0.2
    assert hrt.read_recording(path).reaches == []
    report = hrt.replay(path)
    assert report.complete and report.first_different_line == 0 and report.rows > frame


def test_leaving_the_context_cancels() -> None:
    with hrt.Session() as session:
        with session.set_up(hrt.SetupFlag.REGISTRATION, touches_per_mark=2):
            assert session.state == hrt.StateFlag.SETTING_UP
        assert session.state == 0
        with pytest.raises(hrt.Error, match="touches_per_mark is 9; allowed: 1 to 5"):
            session.set_up(hrt.SetupFlag.REGISTRATION, touches_per_mark=9)

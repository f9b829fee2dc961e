"""Registration: touches of a plate whose pose is known by construction."""

import numpy as np
import pytest

import haptic_retargeting as hrt

MARKS = np.array([(0, 0, 0), (0, 0, 0.05), (0.075, 0, 0), (-0.075, 0, 0), (0, 0, -0.075)])


def rotation_about_y(angle_deg: float) -> np.ndarray:
    c, s = np.cos(np.radians(angle_deg)), np.sin(np.radians(angle_deg))
    return np.array([(c, 0, s), (0, 1, 0), (-s, 0, c)])


def touches(angle_deg: float = 20.0, sd_m: float = 0.001) -> np.ndarray:
    random = np.random.default_rng(1)
    noise = sd_m * random.standard_normal(MARKS.shape)
    return MARKS @ rotation_about_y(angle_deg).T + (1.0, 0.75, -2.0) + noise


def test_pose_goes_into_the_session() -> None:
    found, residuals_m = hrt.register(MARKS, touches(), up=(0, 1, 0))
    assert found.verdict == hrt.RegistrationVerdict.HOLDS and found.left_out == -1
    assert found.plate_position_m[:] == pytest.approx((1.0, 0.75, -2.0), abs=0.002)
    assert found.plate_rotation[:] == pytest.approx((0, np.sin(np.radians(10)), 0, np.cos(np.radians(10))), abs=0.03)
    assert np.sqrt(np.mean(residuals_m**2)) == pytest.approx(found.residual_m)
    with hrt.Session() as session:
        session.apply_registration(found, 7)
        config = session.config
        assert config.plate_position_m[:] == found.plate_position_m[:] and config.registration_time_ns == 7
        assert config.plate_covariance[0] > 0
        assert session.confirm_registration(found, MARKS[1], touches(sd_m=0.0)[1], 8).holds == 1
    assert hrt.check_touch(found, MARKS[1], touches(sd_m=0.0)[1] + (0.04, 0, 0)).holds == 0


def test_bad_touches_are_named() -> None:
    touched = touches()
    touched[3] += (0.05, 0, 0)
    found, residuals_m = hrt.register(MARKS, touched)
    assert found.verdict == hrt.RegistrationVerdict.HOLDS and found.left_out == 3 == np.argmax(residuals_m)
    found, _ = hrt.register(MARKS[[0, 1, 4]], touched[[0, 1, 4]])
    assert found.verdict == hrt.RegistrationVerdict.DEGENERATE
    assert "line" in hrt.registration_advice(found.verdict)
    touched[1] = np.nan
    with pytest.raises(hrt.Error, match=r"touches\[1\].touched_m"):
        hrt.register(MARKS, touched)
    with pytest.raises(ValueError, match="n x 3"):
        hrt.register(MARKS, touched[:, :2])


def test_offset_of_the_fingertip() -> None:
    offset = np.array((0.0, -0.008, -0.012))
    angles = [(axis, angle) for axis in range(3) for angle in (-0.5, 0.0, 0.5)]
    rotation, position = [], []
    for axis, angle in angles:
        quaternion = np.zeros(4)
        quaternion[axis], quaternion[3] = np.sin(angle / 2), np.cos(angle / 2)
        x, y, z, w = quaternion
        v = np.array((x, y, z))
        turned = offset + 2 * np.cross(v, np.cross(v, offset) + w * offset)
        rotation.append(quaternion)
        position.append(np.array((0.2, 0.7, -0.3)) - turned)
    found = hrt.fit_fingertip(position, rotation, touch_sd_m=0.001)
    assert found.known == 1 and found.offset_m[:] == pytest.approx(offset, abs=1e-9)
    assert hrt.fit_fingertip(position[:1] * 4, rotation[:1] * 4).known == 0


def test_latency_of_the_tracker() -> None:
    i = np.arange(600)
    plate_deg = 30 * np.sin(0.02 * i + 2e-5 * i**2)
    late = np.radians(np.concatenate((np.full(5, plate_deg[0]), plate_deg[:-5])))
    finger = 0.07 * np.column_stack((np.cos(late), 0 * late, -np.sin(late)))
    samples = hrt.samples(i * 10_000_000, position_m=finger, plate_orientation_deg=plate_deg)
    found = hrt.fit_latency(samples)
    assert found.known == 1 and found.latency_ns == pytest.approx(50e6, abs=1e6)

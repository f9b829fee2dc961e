import gc

import numpy as np
import pytest
from conftest import ROOT

import haptic_retargeting as hrt
from haptic_retargeting import _abi


def test_configuration_has_defaults_and_takes_keywords() -> None:
    with hrt.Session(horizon=20, guidance=hrt.Guidance.ARRIVAL, start_position_m=(0, 0, 0.04)) as session:
        config = session.config
        assert (config.horizon, config.guidance, list(config.start_position_m)) == (20, 1, [0, 0, 0.04])
        assert config.tactile_weight == 0.2
        session.configure(tactile_weight=np.float64(0.25), horizon=np.int64(4))
        assert (session.config.tactile_weight, session.config.horizon) == (0.25, 4)
        assert "tactile_weight=0.25" in repr(session.config)
        assert session.config == session.config


@pytest.mark.parametrize(
    ("fields", "error", "text"),
    [
        ({"horizn": 3}, TypeError, "horizn"),
        ({"struct_size": 3}, TypeError, "struct_size"),
        ({"horizon": -1}, ValueError, "horizon is -1"),
        ({"horizon": 2.5}, TypeError, "SessionConfig.horizon is 2.5"),
        ({"horizon": 21}, hrt.Error, "horizon"),
        ({"tactile_weight": float("nan")}, hrt.Error, "tactile_weight"),
        ({"tactile_weight": "much"}, TypeError, "SessionConfig.tactile_weight is 'much': a number"),
        ({"plate_position_m": (1, 2)}, ValueError, "SessionConfig.plate_position_m is .*: 3 numbers"),
    ],
)
def test_wrong_configuration_is_refused_by_name(fields, error, text) -> None:
    with pytest.raises(error, match=text):
        hrt.Session(**fields)


def test_closed_session_is_refused() -> None:
    session = hrt.Session()
    session.close()
    session.close()
    with pytest.raises(hrt.Error) as caught:
        session.config
    assert caught.value.code is hrt.ErrorCode.INVALID_HANDLE


def test_unreferenced_sessions_are_destroyed() -> None:
    for _ in range(3 * _abi.SESSIONS_MAX):
        hrt.Session()
    gc.collect()


def test_targets_are_found_listed_changed_and_removed(session: hrt.Session) -> None:
    cup = session.target("cup")
    assert cup == session.targets()[1] and cup.role is hrt.Role.VIRTUAL and cup.name == "cup"
    assert [t.name for t in session.targets(hrt.Role.REAL)] == ["cylinder"]
    cup.configure(direction_deg=6.0)
    assert cup.config.direction_deg == 6.0
    cup.remove()
    assert len(session.targets()) == 1 and "removed" in repr(cup)
    with pytest.raises(hrt.Error) as caught:
        cup.configure(direction_deg=1.0)
    assert caught.value.code is hrt.ErrorCode.INVALID_HANDLE


def test_targets_need_exactly_one_kind_of_position(session: hrt.Session) -> None:
    for error, text, name, place in ((TypeError, "placed by", "nowhere", {}), (ValueError, "allowed: up to 63", "x" * 64, {"direction_deg": 0}),
                                     (TypeError, "placed by", "twice", {"direction_deg": 1, "position_m": (0, 0, 0)}),
                                     (ValueError, "NUL", "a\0b", {"direction_deg": 0})):
        with pytest.raises(error, match=text):
            session.add_real(name, **place)
    with pytest.raises(TypeError, match="TargetConfig.name is 5: a text"):
        session.target("cup").configure(name=5)


def test_targets_by_direction_plate_and_world_position_agree() -> None:
    # The plate is one metre up and rotated by 90 degrees: its x axis is the world's -z.
    turned = (0, np.sqrt(0.5), 0, np.sqrt(0.5))
    with hrt.Session(plate_position_m=(0, 1, 0), plate_rotation=turned) as session:
        on_plate = session.add_virtual("a", position_m=(-0.05, 0, -0.05))
        in_world = session.add_virtual("b", world_position_m=(-0.05, 1, 0.05))
        by_direction = session.add_real("c", direction_deg=20, distance_m=0.08)
        config = session.config
        expected = (np.degrees(np.arctan2(0.05, 0.1)), np.hypot(0.05, 0.1))
        assert hrt.target_place(on_plate.config, config) == pytest.approx(expected)
        assert hrt.target_place(in_world.config, config) == pytest.approx(expected)
        assert hrt.target_place(by_direction.config, config) == (20, 0.08)
        # The two virtual targets are at the same place, and thus have the same gap to the real one.
        gaps = [session.gap(by_direction, t).gap_deg for t in (on_plate, in_world)]
        assert gaps == pytest.approx([expected[0] - 20] * 2)


def test_profile_is_a_mapping_or_text(session: hrt.Session) -> None:
    profile = session.profile
    profile["tactile_weight"] = 0.2
    session.load_profile(profile)
    assert session.config.tactile_weight == 0.2
    session.load_profile('{"format":"haptic retargeting profile","version":1,"tactile_weight":0.3}')
    assert session.config.tactile_weight == 0.3


def test_scene_is_registered() -> None:
    with hrt.Session() as session, hrt.Scene(ROOT / "samples/scenes/desk.gltf") as scene:
        targets = scene.register(session)
        assert [t.name for t in targets] == [t.name for t in scene.targets]
        assert {t.role for t in targets} == {hrt.Role.REAL, hrt.Role.VIRTUAL}
        assert session.config.plate_radius_m == scene.info.plate_radius_m
    with pytest.raises(hrt.Error, match="no.gltf"):
        hrt.Scene("no.gltf")


def test_an_argument_that_is_no_target_is_named(session: hrt.Session) -> None:
    with pytest.raises(TypeError, match="ReachConfig.real_target is 'cylinder': a Target is needed"):
        session.reach("cylinder", session.target("cup"))
    assert session.state == hrt.StateFlag.READY


def test_reprs_are_short(session: hrt.Session) -> None:
    assert repr(session.target("cup")) == "<Target 'cup', virtual, 5 deg, 0.1 m>"
    assert repr(session.state) == "StateFlag.READY" and repr(hrt.StateFlag(0)) == "StateFlag(0)"
    assert repr(hrt.CommandFlag(1 | 16 | 1 << 20)) == "CommandFlag.HELD|UNREACHABLE|0x100000"
    config = session.config
    assert config.guidance is hrt.Guidance.FIXED_DIRECTION
    assert "guidance=FIXED_DIRECTION" in repr(config) and "person_covariance=<55 zeros>" in repr(config)
    assert repr(hrt.Interval(value=1 / 3, known=1)) == "Interval(value=0.333333, lower=0, upper=0, known=1)"
    assert repr(session) == "<Session: 2 targets, READY>"

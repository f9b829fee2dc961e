# Written by plugin/bindings/generate from the C headers.
"""Methods whose keywords are fields of a struct, so that type checkers and editors know them; None: not given."""

from __future__ import annotations

from typing import Any

from ._abi import Adaptation, Control, Guidance, Place, Role, SessionFlag
from ._struct import Numbers


def _given(arguments: dict[str, Any]) -> dict[str, Any]:
    return {name: value for name, value in arguments.items()
            if value is not None and name not in ("self", "session")}


class SessionKeywords:
    """The fields of SessionConfig, by keyword."""

    def __init__(
            self, *, horizon: int | None = None, step_period_ns: int | None = None, control: Control | None = None,
            guidance: Guidance | None = None, adaptation: Adaptation | None = None, flags: SessionFlag | None = None,
            perceived_weight: float | None = None, actual_weight: float | None = None,
            plate_bound_deg: float | None = None, plate_max_speed_deg_s: float | None = None,
            plate_max_acceleration_deg_s2: float | None = None, plate_latency_ns: int | None = None,
            plate_lower_stop_deg: float | None = None, plate_upper_stop_deg: float | None = None,
            fixed_plate_orientation_deg: float | None = None, tactile_weight: float | None = None,
            tactile_weight_sd: float | None = None, motor_variance_deg2: float | None = None,
            sensory_variance_deg2: float | None = None, initial_variance_deg2: float | None = None,
            tracker_noise_m: float | None = None, start_position_m: Numbers | None = None,
            plate_radius_m: float | None = None, lift_height_m: float | None = None,
            plate_position_m: Numbers | None = None, plate_rotation: Numbers | None = None,
            bias_deg: float | None = None, motor_variance_sd_deg2: float | None = None,
            max_felt_error_deg: float | None = None, motion_bound_deg: float | None = None,
            tracker_latency_ns: int | None = None, person_mean: Numbers | None = None,
            person_covariance: Numbers | None = None, plate_scale: float | None = None,
            plate_covariance: Numbers | None = None, registration_time_ns: int | None = None,
            max_registration_age_ns: int | None = None, max_registration_sd_deg: float | None = None,
            tracker_correlated_noise_m: float | None = None, tracker_correlation_s: float | None = None,
            steering_rate_per_s: float | None = None, steering_delay_s: float | None = None,
    ) -> None:
        self._create(_given(locals()))

    def _create(self, fields: dict[str, Any]) -> None:
        raise NotImplementedError

    def configure(
            self, *, horizon: int | None = None, step_period_ns: int | None = None, control: Control | None = None,
            guidance: Guidance | None = None, adaptation: Adaptation | None = None, flags: SessionFlag | None = None,
            perceived_weight: float | None = None, actual_weight: float | None = None,
            plate_bound_deg: float | None = None, plate_max_speed_deg_s: float | None = None,
            plate_max_acceleration_deg_s2: float | None = None, plate_latency_ns: int | None = None,
            plate_lower_stop_deg: float | None = None, plate_upper_stop_deg: float | None = None,
            fixed_plate_orientation_deg: float | None = None, tactile_weight: float | None = None,
            tactile_weight_sd: float | None = None, motor_variance_deg2: float | None = None,
            sensory_variance_deg2: float | None = None, initial_variance_deg2: float | None = None,
            tracker_noise_m: float | None = None, start_position_m: Numbers | None = None,
            plate_radius_m: float | None = None, lift_height_m: float | None = None,
            plate_position_m: Numbers | None = None, plate_rotation: Numbers | None = None,
            bias_deg: float | None = None, motor_variance_sd_deg2: float | None = None,
            max_felt_error_deg: float | None = None, motion_bound_deg: float | None = None,
            tracker_latency_ns: int | None = None, person_mean: Numbers | None = None,
            person_covariance: Numbers | None = None, plate_scale: float | None = None,
            plate_covariance: Numbers | None = None, registration_time_ns: int | None = None,
            max_registration_age_ns: int | None = None, max_registration_sd_deg: float | None = None,
            tracker_correlated_noise_m: float | None = None, tracker_correlation_s: float | None = None,
            steering_rate_per_s: float | None = None, steering_delay_s: float | None = None,
    ) -> None:
        self._configure(_given(locals()))

    def _configure(self, fields: dict[str, Any]) -> None:
        raise NotImplementedError


class TargetKeywords:
    """The fields of TargetConfig, by keyword."""

    def configure(
            self, *, role: Role | None = None, place: Place | None = None, direction_deg: float | None = None,
            distance_m: float | None = None, position_m: Numbers | None = None, name: str | bytes | None = None,
    ) -> None:
        self._configure(_given(locals()))

    def _configure(self, fields: dict[str, Any]) -> None:
        raise NotImplementedError


class CalibrationKeywords:
    """The fields of CalibrationConfig, by keyword."""

    def __init__(
            self, session: SessionKeywords, *, max_trials: int | None = None, max_samples: int | None = None,
            goal_direction_deg: float | None = None, lower_plate_deg: float | None = None,
            upper_plate_deg: float | None = None, enough_weight_width: float | None = None,
    ) -> None:
        self._create(session, _given(locals()))

    def _create(self, session: SessionKeywords, fields: dict[str, Any]) -> None:
        raise NotImplementedError

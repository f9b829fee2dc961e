// Written by plugin/bindings/generate from the C headers.
#include "HapticStructs.h"

#include <cstring>

#include "HapticConversions.h"

namespace HapticConversions
{
	hrt_session_config ToConfig(const FHapticSettings& S, const FTransform& Plate, const hrt_session_config& Before)
	{
		hrt_session_config Config = hrt_session_config_init();
		Config.horizon = static_cast<uint32_t>(S.Horizon);
		Config.step_period_ns = ToNanoseconds(S.StepPeriod);
		Config.control = static_cast<uint32_t>(S.Control);
		Config.guidance = static_cast<uint32_t>(S.Guidance);
		Config.adaptation = static_cast<uint32_t>(S.Adaptation);
		Config.flags = (S.bPlateWaits ? HRT_SESSION_PLATE_WAITS : 0u) | (S.bRegistered ? HRT_SESSION_REGISTERED : 0u);
		Config.perceived_weight = S.PerceivedWeight;
		Config.actual_weight = S.ActualWeight;
		Config.max_felt_error_deg = S.MaxFeltError;
		Config.motion_bound_deg = S.MotionBound;
		Config.max_registration_age_ns = ToNanoseconds(S.MaxRegistrationAge);
		Config.max_registration_sd_deg = S.MaxRegistrationSd;
		Config.steering_rate_per_s = S.SteeringRate;
		Config.steering_delay_s = S.SteeringDelay;
		Config.plate_bound_deg = S.PlateBound;
		Config.plate_max_speed_deg_s = S.PlateMaxSpeed;
		Config.plate_max_acceleration_deg_s2 = S.PlateMaxAcceleration;
		Config.plate_latency_ns = ToNanoseconds(S.PlateLatency);
		Config.plate_lower_stop_deg = Turned(S.PlateUpperStopYaw);
		Config.plate_upper_stop_deg = Turned(S.PlateLowerStopYaw);
		Config.fixed_plate_orientation_deg = Turned(S.FixedPlateYaw);
		ToMetres(S.StartPosition, Config.start_position_m);
		Config.plate_radius_m = S.PlateRadius / CentimetresPerMetre;
		Config.lift_height_m = S.LiftHeight / CentimetresPerMetre;
		Config.plate_scale = S.PlateScale;
		Config.tactile_weight = S.TactileWeight;
		Config.tactile_weight_sd = S.TactileWeightSd;
		Config.motor_variance_deg2 = S.MotorVariance;
		Config.sensory_variance_deg2 = S.SensoryVariance;
		Config.initial_variance_deg2 = S.InitialVariance;
		Config.bias_deg = Turned(S.BiasYaw);
		Config.motor_variance_sd_deg2 = S.MotorVarianceSd;
		Config.tracker_noise_m = S.TrackerNoise / CentimetresPerMetre;
		Config.tracker_latency_ns = ToNanoseconds(S.TrackerLatency);
		Config.registration_time_ns = ToNanoseconds(S.RegistrationTime);
		Config.tracker_correlated_noise_m = S.TrackerCorrelatedNoise / CentimetresPerMetre;
		Config.tracker_correlation_s = S.TrackerCorrelation;
		ToMetres(Plate.GetLocation(), Config.plate_position_m);
		ToQuaternion(Plate.GetRotation(), Config.plate_rotation);
		std::memcpy(Config.person_mean, Before.person_mean, sizeof Config.person_mean);
		std::memcpy(Config.person_covariance, Before.person_covariance, sizeof Config.person_covariance);
		std::memcpy(Config.plate_covariance, Before.plate_covariance, sizeof Config.plate_covariance);
		return Config;
	}

	static FHapticSettings FromSettings(const hrt_session_config& C)
	{
		FHapticSettings Result;
		Result.Horizon = static_cast<int32>(C.horizon);
		Result.StepPeriod = static_cast<double>(C.step_period_ns) / NanosecondsPerSecond;
		Result.Control = static_cast<EHapticControl>(C.control);
		Result.Guidance = static_cast<EHapticGuidance>(C.guidance);
		Result.Adaptation = static_cast<EHapticAdaptation>(C.adaptation);
		Result.bPlateWaits = (C.flags & HRT_SESSION_PLATE_WAITS) != 0;
		Result.bRegistered = (C.flags & HRT_SESSION_REGISTERED) != 0;
		Result.PerceivedWeight = C.perceived_weight;
		Result.ActualWeight = C.actual_weight;
		Result.MaxFeltError = C.max_felt_error_deg;
		Result.MotionBound = C.motion_bound_deg;
		Result.MaxRegistrationAge = static_cast<double>(C.max_registration_age_ns) / NanosecondsPerSecond;
		Result.MaxRegistrationSd = C.max_registration_sd_deg;
		Result.SteeringRate = C.steering_rate_per_s;
		Result.SteeringDelay = C.steering_delay_s;
		Result.PlateBound = C.plate_bound_deg;
		Result.PlateMaxSpeed = C.plate_max_speed_deg_s;
		Result.PlateMaxAcceleration = C.plate_max_acceleration_deg_s2;
		Result.PlateLatency = static_cast<double>(C.plate_latency_ns) / NanosecondsPerSecond;
		Result.PlateLowerStopYaw = Turned(C.plate_upper_stop_deg);
		Result.PlateUpperStopYaw = Turned(C.plate_lower_stop_deg);
		Result.FixedPlateYaw = Turned(C.fixed_plate_orientation_deg);
		Result.StartPosition = FromMetres(C.start_position_m);
		Result.PlateRadius = C.plate_radius_m * CentimetresPerMetre;
		Result.LiftHeight = C.lift_height_m * CentimetresPerMetre;
		Result.PlateScale = C.plate_scale;
		Result.TactileWeight = C.tactile_weight;
		Result.TactileWeightSd = C.tactile_weight_sd;
		Result.MotorVariance = C.motor_variance_deg2;
		Result.SensoryVariance = C.sensory_variance_deg2;
		Result.InitialVariance = C.initial_variance_deg2;
		Result.BiasYaw = Turned(C.bias_deg);
		Result.MotorVarianceSd = C.motor_variance_sd_deg2;
		Result.TrackerNoise = C.tracker_noise_m * CentimetresPerMetre;
		Result.TrackerLatency = static_cast<double>(C.tracker_latency_ns) / NanosecondsPerSecond;
		Result.RegistrationTime = static_cast<double>(C.registration_time_ns) / NanosecondsPerSecond;
		Result.TrackerCorrelatedNoise = C.tracker_correlated_noise_m * CentimetresPerMetre;
		Result.TrackerCorrelation = C.tracker_correlation_s;
		return Result;
	}

	/** Members that differ between `Before` and `Now` become those of `Now`. */
	template <typename... Members>
	static void TakeMembers(const FHapticSettings& Before, const FHapticSettings& Now, FHapticSettings& S,
		Members... Member)
	{
		const auto Take = [](const auto& Old, const auto& New, auto& Into)
		{
			if (std::memcmp(&Old, &New, sizeof New) != 0)
			{
				Into = New;
			}
		};
		(Take(Before.*Member, Now.*Member, S.*Member), ...);
	}

	void TakeChanges(const hrt_session_config& Before, const hrt_session_config& C, FHapticSettings& S)
	{
		TakeMembers(FromSettings(Before), FromSettings(C), S,
			&FHapticSettings::Horizon, &FHapticSettings::StepPeriod, &FHapticSettings::Control,
			&FHapticSettings::Guidance, &FHapticSettings::Adaptation, &FHapticSettings::bPlateWaits,
			&FHapticSettings::bRegistered, &FHapticSettings::PerceivedWeight, &FHapticSettings::ActualWeight,
			&FHapticSettings::MaxFeltError, &FHapticSettings::MotionBound, &FHapticSettings::MaxRegistrationAge,
			&FHapticSettings::MaxRegistrationSd, &FHapticSettings::SteeringRate, &FHapticSettings::SteeringDelay,
			&FHapticSettings::PlateBound, &FHapticSettings::PlateMaxSpeed, &FHapticSettings::PlateMaxAcceleration,
			&FHapticSettings::PlateLatency, &FHapticSettings::PlateLowerStopYaw, &FHapticSettings::PlateUpperStopYaw,
			&FHapticSettings::FixedPlateYaw, &FHapticSettings::StartPosition, &FHapticSettings::PlateRadius,
			&FHapticSettings::LiftHeight, &FHapticSettings::PlateScale, &FHapticSettings::TactileWeight,
			&FHapticSettings::TactileWeightSd, &FHapticSettings::MotorVariance, &FHapticSettings::SensoryVariance,
			&FHapticSettings::InitialVariance, &FHapticSettings::BiasYaw, &FHapticSettings::MotorVarianceSd,
			&FHapticSettings::TrackerNoise, &FHapticSettings::TrackerLatency, &FHapticSettings::RegistrationTime,
			&FHapticSettings::TrackerCorrelatedNoise, &FHapticSettings::TrackerCorrelation);
	}

	FHapticCommand FromCommand(const hrt_command& C)
	{
		FHapticCommand Result;
		Result.Flags = static_cast<int32>(C.flags);
		Result.Step = static_cast<int64>(C.step);
		Result.PlateYaw = Turned(C.plate_orientation_deg);
		Result.FingerYaw = Turned(C.finger_direction_deg);
		Result.PerceivedYaw = Turned(C.perceived_direction_deg);
		Result.AimedYaw = Turned(C.aimed_direction_deg);
		Result.DistanceToGo = C.distance_to_go_m * CentimetresPerMetre;
		Result.TactileWeight = C.tactile_weight;
		Result.TactileWeightSd = C.tactile_weight_sd;
		Result.TimeToGo = C.time_to_go_s;
		Result.FeltErrorYaw = Turned(C.felt_error_deg);
		Result.PredictedMissYaw = Turned(C.predicted_miss_deg);
		Result.NormalisedInnovation = C.normalised_innovation;
		Result.BearingErrorSd = C.bearing_error_sd_deg;
		return Result;
	}

	FHapticSummary FromSummary(const hrt_reach_summary& C)
	{
		FHapticSummary Result;
		Result.Flags = static_cast<int32>(C.flags);
		Result.Samples = static_cast<int64>(C.samples);
		Result.DroppedSamples = static_cast<int64>(C.dropped_samples);
		Result.Steps = static_cast<int64>(C.steps);
		Result.PredictedSteps = static_cast<int64>(C.predicted_steps);
		Result.SaturatedSteps = static_cast<int64>(C.saturated_steps);
		Result.RateLimitedSteps = static_cast<int64>(C.rate_limited_steps);
		Result.FinalYaw = Turned(C.final_direction_deg);
		Result.FinalMissYaw = Turned(C.final_miss_deg);
		Result.PerceivedYaw = Turned(C.perceived_direction_deg);
		Result.PerceivedErrorYaw = Turned(C.perceived_error_deg);
		Result.DistanceToTarget = C.distance_to_target_m * CentimetresPerMetre;
		Result.TactileWeight = C.tactile_weight;
		Result.TactileWeightSd = C.tactile_weight_sd;
		Result.TrackerNoise = C.tracker_noise_m * CentimetresPerMetre;
		Result.MotorVariance = C.motor_variance_deg2;
		Result.MotorVarianceSd = C.motor_variance_sd_deg2;
		Result.BearingErrorYaw = Turned(C.bearing_error_deg);
		Result.PeakFeltError = C.peak_felt_error_deg;
		Result.RmsFeltError = C.rms_felt_error_deg;
		Result.NormalisedInnovation = C.normalised_innovation;
		Result.IllusionCurve = C.illusion_curve;
		Result.IllusionCurveSd = C.illusion_curve_sd;
		Result.Gain = C.gain_per_s;
		Result.GainSd = C.gain_sd_per_s;
		Result.BiasYaw = Turned(C.bias_deg);
		Result.BiasSd = C.bias_sd_deg;
		Result.HabitYaw = Turned(C.habit_deg);
		Result.HabitSd = C.habit_sd_deg;
		Result.Duration = C.duration_s;
		Result.BearingErrorSd = C.bearing_error_sd_deg;
		return Result;
	}

	FHapticAuthority FromAuthority(const hrt_authority& C)
	{
		FHapticAuthority Result;
		Result.bReachable = C.reachable != 0;
		Result.RealTarget = FromTarget(C.real_target);
		Result.VirtualTarget = FromTarget(C.virtual_target);
		Result.GapYaw = Turned(C.gap_deg);
		Result.MaxGap = C.max_gap_deg;
		Result.Margin = C.margin_deg;
		Result.PlateYaw = Turned(C.plate_orientation_deg);
		Result.SettlingYaw = Turned(C.settling_direction_deg);
		Result.PaperMaxGap = C.paper_max_gap_deg;
		return Result;
	}

	FHapticCalibration FromCalibration(const hrt_calibration_result& C)
	{
		FHapticCalibration Result;
		Result.SlidesTurning = static_cast<int32>(C.slides_turning);
		Result.Trials = static_cast<int32>(C.trials);
		Result.TrialsUsed = static_cast<int32>(C.trials_used);
		Result.TactileWeight = FromInterval(C.tactile_weight, 1.0);
		Result.BiasYaw = FromMirrored(C.bias_deg);
		Result.MotorVariance = FromInterval(C.motor_variance_deg2, 1.0);
		Result.SensoryVariance = FromInterval(C.sensory_variance_deg2, 1.0);
		Result.TrackerNoise = FromInterval(C.tracker_noise_m, CentimetresPerMetre);
		Result.Illusion = static_cast<EHapticIllusion>(C.illusion);
		Result.LackOfFit = static_cast<int32>(C.lack_of_fit);
		Result.SlidesOutlying = static_cast<int32>(C.slides_outlying);
		Result.SlidesAlongRidges = static_cast<int32>(C.slides_along_ridges);
		Result.IllusionScale = C.illusion_scale_deg;
		Result.PeakOffset = C.peak_offset_deg;
		Result.PersonWeight = FromInterval(C.person_weight, 1.0);
		Result.PersonCurve = FromInterval(C.person_curve, 1.0);
		Result.WeightCurveCorrelation = C.weight_curve_correlation;
		Result.MaxGap = FromInterval(C.max_gap_deg, 1.0);
		Result.HabitYaw = FromMirrored(C.habit_deg);
		Result.CorrelatedNoise = FromInterval(C.correlated_noise_m, CentimetresPerMetre);
		Result.NoiseCorrelation = FromInterval(C.noise_correlation_s, 1.0);
		Result.AngleP = C.angle_p;
		Result.OrderP = C.order_p;
		Result.PathP = C.path_p;
		Result.SteeringRate = FromInterval(C.steering_rate_per_s, 1.0);
		Result.SteeringDelay = FromInterval(C.steering_delay_s, 1.0);
		Result.SteeringP = C.steering_p;
		return Result;
	}

	FHapticSlide FromSlide(const hrt_calibration_slide& C)
	{
		FHapticSlide Result;
		Result.Verdict = static_cast<EHapticSlide>(C.verdict);
		Result.Trial = static_cast<int32>(C.trial);
		Result.PlateYaw = Turned(C.plate_deg);
		Result.Yaw = Turned(C.direction_deg);
		Result.FittedYaw = Turned(C.fitted_deg);
		Result.ResidualYaw = Turned(C.residual_deg);
		return Result;
	}

	FHapticCalibrationComparison FromCalibrationComparison(const hrt_calibration_comparison& C)
	{
		FHapticCalibrationComparison Result;
		Result.Differing = static_cast<int32>(C.differing);
		Result.TactileWeight = FromInterval(C.tactile_weight, 1.0);
		Result.MaxGap = FromInterval(C.max_gap_deg, 1.0);
		Result.BiasYaw = FromMirrored(C.bias_deg);
		Result.HabitYaw = FromMirrored(C.habit_deg);
		Result.TrackerNoise = FromInterval(C.tracker_noise_m, CentimetresPerMetre);
		Result.SteeringRate = FromInterval(C.steering_rate_per_s, 1.0);
		Result.SteeringDelay = FromInterval(C.steering_delay_s, 1.0);
		return Result;
	}

	FHapticRegistration FromRegistration(const hrt_registration& C)
	{
		FHapticRegistration Result;
		Result.Verdict = static_cast<EHapticRegistrationVerdict>(C.verdict);
		Result.Touches = static_cast<int32>(C.touches);
		Result.LeftOut = static_cast<int32>(C.left_out);
		Result.PlatePosition = FromMetres(C.plate_position_m);
		Result.PlateScale = C.plate_scale;
		Result.TouchSd = C.touch_sd_m * CentimetresPerMetre;
		Result.Residual = C.residual_m * CentimetresPerMetre;
		Result.TurnSd = C.turn_sd_deg;
		return Result;
	}

	FHapticTouchCheck FromTouchCheck(const hrt_touch_check& C)
	{
		FHapticTouchCheck Result;
		Result.bHolds = C.holds != 0;
		Result.Distance = C.distance_m * CentimetresPerMetre;
		Result.Allowed = C.allowed_m * CentimetresPerMetre;
		return Result;
	}

	FHapticFingertip FromFingertip(const hrt_fingertip& C)
	{
		FHapticFingertip Result;
		Result.bKnown = C.known != 0;
		Result.Offset = FromMetres(C.offset_m);
		return Result;
	}

	FHapticSceneTarget FromSceneTarget(const hrt_scene_target& C)
	{
		FHapticSceneTarget Result;
		Result.Role = static_cast<EHapticTargetRole>(C.role);
		Result.ServedBy = static_cast<int32>(C.served_by);
		Result.Position = FromMetres(C.position_m);
		Result.WorldPosition = FromMetres(C.world_position_m);
		Result.Yaw = Turned(C.direction_deg);
		Result.Distance = C.distance_m * CentimetresPerMetre;
		Result.Radius = C.radius_m * CentimetresPerMetre;
		Result.Name = FString(UTF8_TO_TCHAR(C.name));
		return Result;
	}
}

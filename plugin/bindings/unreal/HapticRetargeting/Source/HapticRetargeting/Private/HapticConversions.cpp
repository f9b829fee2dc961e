#include "HapticConversions.h"

#include <cmath>
#include <string>

namespace HapticConversions
{
	static_assert(static_cast<int>(EHapticControl::ModelPredictive) == HRT_CONTROL_MPC);
	static_assert(static_cast<int>(EHapticControl::FixedPlate) == HRT_CONTROL_FIXED_PLATE);
	static_assert(static_cast<int>(EHapticGuidance::FixedDirection) == HRT_GUIDANCE_FIXED_DIRECTION);
	static_assert(static_cast<int>(EHapticGuidance::Arrival) == HRT_GUIDANCE_ARRIVAL);
	static_assert(static_cast<int>(EHapticAdaptation::Off) == HRT_ADAPTATION_OFF);
	static_assert(static_cast<int>(EHapticAdaptation::Reach) == HRT_ADAPTATION_REACH);
	static_assert(static_cast<int>(EHapticAdaptation::Carried) == HRT_ADAPTATION_CARRIED);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Held) == HRT_COMMAND_HELD);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Predicted) == HRT_COMMAND_PREDICTED);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Saturated) == HRT_COMMAND_SATURATED);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::RateLimited) == HRT_COMMAND_RATE_LIMITED);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Unreachable) == HRT_COMMAND_UNREACHABLE);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Lifted) == HRT_COMMAND_LIFTED);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::OffPlate) == HRT_COMMAND_OFF_PLATE);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Misfit) == HRT_COMMAND_MISFIT);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::OffTarget) == HRT_COMMAND_OFF_TARGET);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Resting) == HRT_COMMAND_RESTING);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Approximate) == HRT_COMMAND_APPROXIMATE);
	static_assert(static_cast<uint32_t>(EHapticCommandFlags::Fault) == HRT_COMMAND_FAULT);

	static constexpr double CentimetresPerMetre = 100.0;

	void ToMetres(const FVector& Centimetres, double (&OutMetres)[3])
	{
		OutMetres[0] = Centimetres.Y / CentimetresPerMetre;
		OutMetres[1] = Centimetres.Z / CentimetresPerMetre;
		OutMetres[2] = 0.0 - Centimetres.X / CentimetresPerMetre;
	}

	void ToQuaternion(const FQuat& Rotation, double (&OutRotation)[4])
	{
		OutRotation[0] = 0.0 - Rotation.Y;
		OutRotation[1] = 0.0 - Rotation.Z;
		OutRotation[2] = Rotation.X;
		OutRotation[3] = Rotation.W;
	}

	int64_t ToNanoseconds(double Seconds)
	{
		// Beyond this, and for what is not a number, the plugin's own refusal is provoked: llround is undefined there.
		constexpr double Largest = 9e9;
		return std::abs(Seconds) < Largest ? static_cast<int64_t>(std::llround(Seconds * 1e9)) : INT64_MIN;
	}

	bool IsPose(const FTransform& Transform)
	{
		return Transform.GetScale3D().Equals(FVector(1.0, 1.0, 1.0), 1e-3);
	}

	hrt_session_config ToConfig(const FHapticSettings& Settings, const FTransform& Plate)
	{
		hrt_session_config Config = hrt_session_config_init();
		// A negative number becomes one that is out of range.
		Config.horizon = static_cast<uint32_t>(Settings.Horizon);
		Config.step_period_ns = ToNanoseconds(Settings.StepPeriod);
		Config.control = static_cast<uint32_t>(Settings.Control);
		Config.guidance = static_cast<uint32_t>(Settings.Guidance);
		Config.adaptation = static_cast<uint32_t>(Settings.Adaptation);
		Config.flags = Settings.bPlateWaits ? HRT_SESSION_PLATE_WAITS : 0;
		Config.max_felt_error_deg = Settings.MaxFeltError;
		Config.motion_bound_deg = Settings.MotionBound;
		Config.perceived_weight = Settings.PerceivedWeight;
		Config.actual_weight = Settings.ActualWeight;
		Config.plate_bound_deg = Settings.PlateBound;
		Config.plate_max_speed_deg_s = Settings.PlateMaxSpeed;
		Config.plate_max_acceleration_deg_s2 = Settings.PlateMaxAcceleration;
		Config.plate_latency_ns = ToNanoseconds(Settings.PlateLatency);
		Config.plate_lower_stop_deg = Turned(Settings.PlateUpperStopYaw);
		Config.plate_upper_stop_deg = Turned(Settings.PlateLowerStopYaw);
		Config.fixed_plate_orientation_deg = Turned(Settings.FixedPlateYaw);
		Config.tactile_weight = Settings.TactileWeight;
		Config.tactile_weight_sd = Settings.TactileWeightSd;
		Config.bias_deg = Turned(Settings.BiasYaw);
		Config.motor_variance_deg2 = Settings.MotorVariance;
		Config.motor_variance_sd_deg2 = Settings.MotorVarianceSd;
		Config.sensory_variance_deg2 = Settings.SensoryVariance;
		Config.initial_variance_deg2 = Settings.InitialVariance;
		Config.tracker_noise_m = Settings.TrackerNoise / CentimetresPerMetre;
		Config.tracker_latency_ns = ToNanoseconds(Settings.TrackerLatency);
		ToMetres(Settings.StartPosition, Config.start_position_m);
		Config.plate_radius_m = Settings.PlateRadius / CentimetresPerMetre;
		Config.lift_height_m = Settings.LiftHeight / CentimetresPerMetre;
		ToMetres(Plate.GetLocation(), Config.plate_position_m);
		ToQuaternion(Plate.GetRotation(), Config.plate_rotation);
		return Config;
	}

	void TakeUser(const hrt_session_config& Config, FHapticSettings& Settings)
	{
		Settings.TactileWeight = Config.tactile_weight;
		Settings.TactileWeightSd = Config.tactile_weight_sd;
		Settings.BiasYaw = Turned(Config.bias_deg);
		Settings.MotorVariance = Config.motor_variance_deg2;
		Settings.MotorVarianceSd = Config.motor_variance_sd_deg2;
		Settings.SensoryVariance = Config.sensory_variance_deg2;
		Settings.InitialVariance = Config.initial_variance_deg2;
		Settings.TrackerNoise = Config.tracker_noise_m * CentimetresPerMetre;
	}

	hrt_target_config ToTarget(EHapticTargetRole Role, const FString& Name)
	{
		hrt_target_config Config = hrt_target_config_init();
		Config.role = Role == EHapticTargetRole::Real ? HRT_TARGET_REAL : HRT_TARGET_VIRTUAL;
		// A name that does not fit has no zero at its end, which the plugin refuses.
		std::string(TCHAR_TO_UTF8(*Name)).copy(Config.name, sizeof Config.name);
		return Config;
	}

	FHapticTarget FromTarget(hrt_target Target)
	{
		FHapticTarget Result;
		Result.Id = static_cast<int64>(Target.value);
		return Result;
	}

	FHapticCommand FromCommand(const hrt_command& Command)
	{
		FHapticCommand Result;
		Result.Flags = static_cast<int32>(Command.flags);
		Result.Step = Command.step;
		Result.PlateYaw = Turned(Command.plate_orientation_deg);
		Result.FingerYaw = Turned(Command.finger_direction_deg);
		Result.PerceivedYaw = Turned(Command.perceived_direction_deg);
		Result.AimedYaw = Turned(Command.aimed_direction_deg);
		Result.DistanceToGo = Command.distance_to_go_m * CentimetresPerMetre;
		Result.TactileWeight = Command.tactile_weight;
		Result.TactileWeightSd = Command.tactile_weight_sd;
		Result.TimeToGo = Command.time_to_go_s;
		Result.FeltErrorYaw = Turned(Command.felt_error_deg);
		Result.PredictedMissYaw = Turned(Command.predicted_miss_deg);
		Result.NormalisedInnovation = Command.normalised_innovation;
		return Result;
	}

	FHapticSummary FromSummary(const hrt_reach_summary& Summary)
	{
		FHapticSummary Result;
		Result.Flags = static_cast<int32>(Summary.flags);
		Result.Samples = Summary.samples;
		Result.DroppedSamples = Summary.dropped_samples;
		Result.Steps = Summary.steps;
		Result.PredictedSteps = Summary.predicted_steps;
		Result.SaturatedSteps = Summary.saturated_steps;
		Result.RateLimitedSteps = Summary.rate_limited_steps;
		Result.FinalYaw = Turned(Summary.final_direction_deg);
		Result.FinalMissYaw = Turned(Summary.final_miss_deg);
		Result.PerceivedYaw = Turned(Summary.perceived_direction_deg);
		Result.PerceivedErrorYaw = Turned(Summary.perceived_error_deg);
		Result.DistanceToTarget = Summary.distance_to_target_m * CentimetresPerMetre;
		Result.TactileWeight = Summary.tactile_weight;
		Result.TactileWeightSd = Summary.tactile_weight_sd;
		Result.TrackerNoise = Summary.tracker_noise_m * CentimetresPerMetre;
		Result.MotorVariance = Summary.motor_variance_deg2;
		Result.MotorVarianceSd = Summary.motor_variance_sd_deg2;
		Result.BearingErrorYaw = Turned(Summary.bearing_error_deg);
		Result.PeakFeltError = Summary.peak_felt_error_deg;
		Result.RmsFeltError = Summary.rms_felt_error_deg;
		Result.NormalisedInnovation = Summary.normalised_innovation;
		Result.IllusionCurve = Summary.illusion_curve;
		Result.IllusionCurveSd = Summary.illusion_curve_sd;
		Result.Gain = Summary.gain_per_s;
		Result.GainSd = Summary.gain_sd_per_s;
		Result.BiasYaw = Turned(Summary.bias_deg);
		Result.BiasSd = Summary.bias_sd_deg;
		Result.HabitYaw = Turned(Summary.habit_deg);
		Result.HabitSd = Summary.habit_sd_deg;
		Result.Duration = Summary.duration_s;
		return Result;
	}

	static FHapticInterval FromInterval(const hrt_interval& Interval, double Scale)
	{
		FHapticInterval Result;
		Result.Value = Interval.value * Scale;
		Result.Lower = Interval.lower * Scale;
		Result.Upper = Interval.upper * Scale;
		Result.bKnown = Interval.known != 0;
		return Result;
	}

	FHapticCalibration FromCalibration(const hrt_calibration_result& User)
	{
		FHapticCalibration Result;
		Result.Trials = static_cast<int32>(User.trials);
		Result.TrialsUsed = static_cast<int32>(User.trials_used);
		Result.TactileWeight = FromInterval(User.tactile_weight, 1.0);
		Result.BiasYaw.Value = Turned(User.bias_deg.value);
		Result.BiasYaw.Lower = Turned(User.bias_deg.upper);
		Result.BiasYaw.Upper = Turned(User.bias_deg.lower);
		Result.BiasYaw.bKnown = User.bias_deg.known != 0;
		Result.MotorVariance = FromInterval(User.motor_variance_deg2, 1.0);
		Result.SensoryVariance = FromInterval(User.sensory_variance_deg2, 1.0);
		Result.TrackerNoise = FromInterval(User.tracker_noise_m, CentimetresPerMetre);
		return Result;
	}

	FHapticAuthority FromAuthority(const hrt_authority& Authority)
	{
		FHapticAuthority Result;
		Result.bReachable = Authority.reachable != 0;
		Result.RealTarget = FromTarget(Authority.real_target);
		Result.VirtualTarget = FromTarget(Authority.virtual_target);
		Result.GapYaw = Turned(Authority.gap_deg);
		Result.LargestGap = Authority.largest_gap_deg;
		Result.Margin = Authority.margin_deg;
		Result.PlateYaw = Turned(Authority.plate_orientation_deg);
		Result.SettlingYaw = Turned(Authority.settling_direction_deg);
		Result.PaperLargestGap = Authority.paper_largest_gap_deg;
		return Result;
	}
}

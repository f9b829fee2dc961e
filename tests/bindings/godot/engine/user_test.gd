# What is kept of a user: calibrations, profiles, recordings.
extends "res://tests/checks.gd"

func test_profile() -> void:
	var plate := new_plate()
	plate.tactile_weight = 0.25
	var profile := plate.save_profile()
	check_near(JSON.parse_string(profile).tactile_weight, 0.25, "tactile weight in the profile")
	var other := new_plate()
	check_equal(other.load_profile(profile), OK, "load")
	check_equal(other.tactile_weight, 0.25, "tactile weight from the profile")
	check_equal(refused("hrt_profile_load", other.load_profile.bind("{")), ERR_PARSE_ERROR, "half a profile")

func test_adaptation() -> void:
	var plate := reaching_plate()
	for frame in 270:
		plate.update(Vector3(0, 0, 0.05 - frame * 0.1 / 270), frame * 11111111)
	plate.horizon = 4
	check_equal(plate.end(), OK, "end")
	check_equal(plate.horizon, 4, "a property set during a reach that learns")
	check_equal(plate.tactile_weight, plate.get_summary().tactile_weight, "what a reach has learnt, carried")
	check(plate.tactile_weight != 0.2, "something is learnt")

# A simulated user whose share of touch is known slides over a plate at rest.
func test_calibration() -> void:
	var plate := new_plate()
	check_equal(refused("hrt_calibration_begin_trial", plate.begin_trial.bind(0.0)), ERR_DOES_NOT_EXIST,
			"a trial without a calibration")
	check_equal(plate.begin_calibration(0.0), OK, "begin")
	check(refused("hrt_calibration_solve", plate.solve_calibration).is_empty(), "a solution without trials")
	check_equal(refused("apply_calibration: no calibration is solved", plate.apply_calibration), ERR_UNAVAILABLE,
			"nothing to apply")
	var random := RandomNumberGenerator.new()
	random.seed = 1
	slides(plate, random)
	check_equal(plate.begin_trial(0.0), OK, "a trial more")
	check_equal(plate.cancel_trial(), OK, "and not")
	var found := plate.solve_calibration()
	check_equal(found.trials_used, 20, "trials used")
	check(found.tactile_weight_lower < 0.15 and 0.15 < found.tactile_weight_upper, "the interval of the tactile weight: %s" % found)
	check(found.tactile_weight_upper - found.tactile_weight_lower < 0.1, "is narrow: %s" % found)
	check_equal(found.tactile_weight_known, 1, "known")
	check(absf(plate.get_next_angle().plate_orientation_deg) <= 75, "the next angle")
	check_equal(plate.get_slide(0).trial, 0, "a slide")
	check_equal(plate.set_conditions("desk 1", "Ultraleap", 1767225600), OK, "conditions")
	check_equal(plate.apply_calibration(), OK, "apply")
	check_equal(plate.set_conditions("desk 2", "Ultraleap", 0), OK, "other conditions")
	check_equal(plate.get_conditions(), {"differing": HapticRetargeting.CONDITION_PLATE, "time_s": 1767225600}, "another plate")
	check_equal(plate.tactile_weight, found.tactile_weight, "tactile weight, applied")
	check_equal(plate.bias_deg, found.bias_deg, "bias, applied")
	check(refused("compare_calibrations: it needs two calibrations", plate.compare_calibrations).is_empty(),
			"one calibration is no comparison")
	check_equal(refused("upper_plate_deg is 0", plate.begin_calibration_within.bind(0.0, -30.0, 0.0, 0.02)),
			ERR_PARAMETER_RANGE_ERROR, "a range of no width")
	check_equal(plate.begin_calibration(0.0), OK, "a second calibration")
	random.seed = 2
	slides(plate, random)
	var again := plate.solve_calibration()
	var change := plate.compare_calibrations()
	check_near(change.tactile_weight, again.tactile_weight - found.tactile_weight, "test and retest")
	check_equal(change.differing & HapticRetargeting.DIFFERS_TACTILE_WEIGHT, 0, "the same user")
	check_equal(plate.end_calibration(), OK, "end")
	check_equal(refused("hrt_calibration_destroy", plate.end_calibration), ERR_DOES_NOT_EXIST, "end twice")

func slides(plate: HapticRetargeting, random: RandomNumberGenerator) -> void:
	for round_of_trials in 4:
		for plate_deg: float in [-60.0, -30.0, 0.0, 30.0, 60.0]:
			slide(plate, plate_deg, random)

func slide(plate: HapticRetargeting, plate_deg: float, random: RandomNumberGenerator) -> void:
	var user := preload("res://tests/user.gd").new()
	var finger := Vector3(0, 0.002, 0.05)
	check_equal(plate.begin_trial(plate_deg), OK, "begin of a trial")
	for frame in 315:
		var seconds := frame / 90.0 - 0.5
		if seconds > 0:
			if user.feel_until(seconds, plate_deg):
				user.direction_deg += random.randfn(0, 0.7)
			finger += Vector3.FORWARD.rotated(Vector3.UP, deg_to_rad(user.direction_deg)) * 0.1 / 270
		var seen := finger + Vector3(random.randfn(0, 0.0003), 0, random.randfn(0, 0.0003))
		check_equal(plate.add_trial_sample(seen, frame * 11111111), OK, "sample")
	check_equal(plate.end_trial(), OK, "end of a trial")

func test_recording() -> void:
	var plate := new_plate()
	var path := OS.get_user_data_dir().path_join("recording.csv")
	DirAccess.make_dir_recursive_absolute(OS.get_user_data_dir())
	check_equal(plate.start_recording(path), OK, "start")
	plate.begin(plate.add_real_target("real", -5.0, 0.1), plate.add_virtual_target("felt", 5.0, 0.1))
	plate.update(Vector3(), 0)
	plate.end()
	check_equal(plate.get_recording_status().rows_lost, 0, "status")
	check_equal(plate.stop_recording(), OK, "stop")
	var file := FileAccess.open(path, FileAccess.READ)
	check(file != null and file.get_line().begins_with("# haptic retargeting recording, version "), "first line")
	check_equal(refused("hrt_recording_stop", plate.stop_recording), ERR_UNAVAILABLE, "stop twice")
	check_equal(refused("hrt_recording_start", plate.start_recording.bind("/nowhere/recording.csv")), ERR_FILE_CANT_WRITE,
			"a folder that is not there")

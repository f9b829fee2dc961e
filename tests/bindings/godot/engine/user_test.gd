# Tests profiles and recordings of a user.
extends "res://tests/checks.gd"

func test_profile() -> void:
	var plate := new_plate()
	plate.tactile_weight = 0.25
	var profile := plate.save_profile()
	check_near(JSON.parse_string(profile).tactile_weight, 0.25, "tactile weight in the profile")
	var other := new_plate()
	check_equal(other.load_profile(profile), OK, "load")
	check_equal(other.tactile_weight, 0.25, "tactile weight from the profile")
	check_equal(refused("load_profile", other.load_profile.bind("{")), ERR_PARSE_ERROR, "half a profile")

func test_adaptation() -> void:
	var plate := reaching_plate()
	for frame in 270:
		plate.update(Vector3(0, 0, 0.05 - frame * 0.1 / 270), frame * 11111111)
	plate.horizon = 4
	check_equal(plate.end(), OK, "end")
	check_equal(plate.horizon, 4, "a property set during a reach that learns")
	check_near(plate.tactile_weight, plate.get_summary().tactile_weight, "the estimate of the reach is carried over", 0.002)  # filtered again after the reach
	check(plate.tactile_weight != 0.2, "something is learnt")

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
	check_equal(refused("stop_recording", plate.stop_recording), ERR_UNAVAILABLE, "stop twice")
	check_equal(refused("start_recording", plate.start_recording.bind("/nowhere/recording.csv")), ERR_FILE_CANT_OPEN,
			"a folder that is not there")

extends "res://tests/checks.gd"

func test_properties() -> void:
	var plate: HapticRetargeting = load("res://tests/readme.tscn").instantiate().get_node("Plate")
	check_equal(plate.get_class(), "HapticRetargeting", "class")
	check(plate is Node3D, "a Node3D")
	check_equal(plate.horizon, 7, "horizon of the scene")
	check_equal(plate.start_position_m, Vector3(0, 0, 0.0625), "start of the scene")
	check_equal(plate.step_period_ns, 100000000, "default step period")
	check_equal(plate.tactile_weight, 0.2, "default tactile weight, a double")
	plate.perceived_weight = 2
	check_equal(plate.perceived_weight, 2.0, "a whole number in place of a float")
	refused("horizon was given a value of type String; allowed: int from 0 to 4294967295",
			func() -> void: plate.call("set_horizon", "three"))
	refused("horizon was given a value of type int; allowed: int from 0 to 4294967295",
			func() -> void: plate.horizon = -1)
	check_equal(plate.horizon, 7, "horizon after a refused value")
	plate.plate_bound_deg = 91.0
	check_equal(refused("plate_bound_deg is 91; allowed: 0.1 to 90", plate.add_real_target.bind("real", 0.0, 0.1)), 0,
			"a target while a property is out of range")
	plate.plate_bound_deg = 84.5
	plate.plate_upper_stop_deg = 90
	plate.plate_lower_stop_deg = -90
	check(plate.add_real_target("real", 0.0, 0.1) != 0, "stops may be set one after the other")
	plate.owner.free()

func test_registered() -> void:
	var listed := {}
	for property in ClassDB.class_get_property_list("HapticRetargeting", true):
		listed[property.name] = property
	check(listed.size() > 29, "properties: %d" % listed.size())
	check_equal(listed["control"].hint_string, "MPC,Fixed Plate", "the inspector's choices for control")
	check_equal(listed["tactile_weight"].type, TYPE_FLOAT, "type of tactile_weight")
	check_equal(listed["plate_bound_deg"].hint_string, "0.1,90,0.00001,suffix:°", "range of a property")
	check_equal([listed["flags"].hint, listed["flags"].hint_string.get_slice(",", 0)], [PROPERTY_HINT_FLAGS, "Plate Waits:1"], "boxes of flags")
	check_equal(listed["Setup"].usage, PROPERTY_USAGE_GROUP, "a group of the inspector")
	check_equal(HapticRetargeting.GUIDANCE_ARRIVAL, 1, "a constant")
	check(ClassDB.class_get_enum_constants("HapticRetargeting", "Command").has("COMMAND_SATURATED"), "an enumeration")
	check(not ClassDB.class_has_integer_constant("HapticRetargeting", "ERROR_BUSY"), "methods return Godot's own errors")
	for signal_of in ClassDB.class_get_signal_list("HapticRetargeting", true):
		check(signal_of.name in ["plate_commanded", "flags_changed", "arrived", "reach_ended", "setup_step", "setup_finished"], signal_of.name)
		check_equal(signal_of.args.size(), 1, "arguments of " + signal_of.name)

func test_names() -> void:
	var plate := new_plate()
	check_equal(refused("add_real_target", plate.add_real_target.bind("n".repeat(64), 0.0, 0.1)), 0, "a name of 64 bytes")
	check(plate.add_real_target("n".repeat(63), 0.0, 0.1) != 0, "a name of 63 bytes")
	plate.name = &"Plate"
	check(plate.add_real_target(plate.name, 0.0, 0.1) != 0, "the name of a node")
	check(refused("Plate", plate.callv.bind("add_real_target", [&"Plate", 0.0, 0.1])) == 0, "that name again, untyped")

# Godot's axes are the plate's: x right, y up, -z away. A plate that is rotated and moved together with the finger
# gives the same commands as a plate at the origin, except for the rounding of floats.
func test_axes() -> void:
	var plate := new_plate()
	var left := plate.add_real_target_at("left", Vector3(-0.1, 0.02, 0.05))
	var ahead := plate.add_virtual_target_at("ahead", Vector3(0, 0, -0.05))
	check_near(plate.get_gap(left, ahead).gap_deg, -90.0, "gap from left (+90) to ahead (0)")

	var turned := new_plate()
	turned.rotation_degrees = Vector3(20, 125, -7)
	turned.position = Vector3(1.5, 0.75, -2.25)
	var outputs: Array[Dictionary] = []
	for each: HapticRetargeting in [new_plate(), turned]:
		var pose := each.global_transform
		var real := each.add_real_target_at("real", pose * Vector3(-0.01, 0, -0.05))
		var felt := each.add_virtual_target_at("felt", pose * Vector3(0.005, 0, -0.05))
		check_equal(each.begin(real, felt), OK, "begin")
		for frame in 270:
			check_equal(each.update(pose * Vector3(-0.00003 * frame, 0.002, 0.05 - frame * 0.1 / 270), frame * 11111111), OK,
					"update")
		outputs.append(each.get_command())
		check_equal(each.end(), OK, "end")
	check(outputs[0].bearing_deg > 2, "a finger that goes left has a positive direction")
	check(outputs[0].plate_orientation_deg < -5, "the plate turns right to deflect the hand to the left of the perceived path")
	for field: String in outputs[0]:
		check_near(outputs[1][field], outputs[0][field], field + " on the turned plate", 0.01)

	turned.scale = Vector3(2, 2, 2)
	check_equal(refused("the node is scaled, sheared or mirrored in the world", turned.begin.bind(1, 2)),
			ERR_PARAMETER_RANGE_ERROR, "begin on a scaled plate")
	var outside := HapticRetargeting.new()
	check(outside.add_real_target("real", 0.0, 0.1) != 0, "a plate outside the tree")
	outside.free()

func test_signals() -> void:
	var plate := new_plate()
	var heard := []
	for of: Signal in [plate.plate_commanded, plate.flags_changed, plate.reach_ended]:
		of.connect(func(argument: Variant) -> void: heard.append([of.get_name(), argument]))
	var real := plate.add_real_target("real", -5.0, 0.1)
	var felt := plate.add_virtual_target("felt", 5.0, 0.1)
	check_equal(plate.is_reaching(), false, "reaching before")
	check(plate.get_command().is_empty(), "command before")
	check_equal(plate.begin_with_plate_at(real, felt, 12.5), OK, "begin")
	check_equal(plate.is_reaching(), true, "reaching")
	plate.update_sample(HapticRetargeting.SAMPLE_DIRECTION, 0, 0.0, 0.0, 0.0, 0.0, 0.0)
	plate.update_sample(HapticRetargeting.SAMPLE_DIRECTION, 50000000, 0.0, 0.0, 0.0, 0.0, 0.0)
	check_equal(heard, [[&"flags_changed", HapticRetargeting.COMMAND_MISS_UNKNOWN],
			[&"plate_commanded", plate.get_command().plate_orientation_deg]], "signals of a step and of a sample between steps")
	check(plate.get_command().flags & HapticRetargeting.COMMAND_HELD != 0, "the flag HELD between steps")
	heard.clear()
	check_equal(plate.update_lost(250000000), OK, "a dropout")
	check(heard.size() > 0 and heard[0][0] == &"flags_changed" and
			heard[0][1] & HapticRetargeting.COMMAND_PREDICTED != 0, "flags_changed with PREDICTED: %s" % [heard])
	heard.clear()
	check_equal(plate.end(), OK, "end")
	check_equal(heard, [[&"reach_ended", plate.get_summary().miss_deg]], "signals of the end")
	check_equal(plate.get_summary().samples, 3, "samples")

func test_refusals() -> void:
	var plate := new_plate()
	check_equal(refused("update", plate.update_lost.bind(0)), ERR_DOES_NOT_EXIST, "update without a session")
	plate = reaching_plate()
	check(plate.get_summary().is_empty(), "summary without a reach")
	check_equal(plate.update(Vector3(), 1000), OK, "update")
	check_equal(refused("time_ns is 999", plate.update.bind(Vector3(), 999)), ERR_INVALID_DATA, "time that runs backwards")
	check_equal(plate.update(Vector3(), 999), ERR_INVALID_DATA, "a repeated error, which is logged once per reach")
	check_equal(refused("update: finger_position_m", plate.update.bind(Vector3(NAN, 0, 0), 2000)), ERR_PARAMETER_RANGE_ERROR,
			"not a number")
	check_equal(refused("called with (Vector3, float)", func() -> Error: return plate.update(Vector3(), 2.0)), ERR_INVALID_PARAMETER,
			"a time in seconds")
	for arguments: Array in [[Vector3()], ["here", 2000], [self, 2000]]:
		check_equal(refused("; allowed: update(world_position: Vector3, time_ns: int)", plate.callv.bind("update", arguments)),
				ERR_INVALID_PARAMETER, "update with %s" % [arguments])
	check_equal(refused("allowed: update_sample(flags: int", plate.callv.bind("update_sample", range(20))), ERR_INVALID_PARAMETER,
			"far too many arguments")
	for flags: int in [HapticRetargeting.SAMPLE_PLATE_POSE, -1]:  # a pose that is not given; unknown flags
		check_equal(refused("update: ", reaching_plate().update_sample.bind(flags, 2000, 0.0, 0.0, 0.0, 0.0, 0.0)), ERR_PARAMETER_RANGE_ERROR,
				"flags %d" % flags)
	check_equal(plate.update(Vector3(), 2000), OK, "update after refusals")
	plate.horizon = 5
	check_equal(plate.update(Vector3(), 3000), OK, "a property set during a reach waits")
	check_equal(plate.end(), OK, "end")

# The estimate of a reach is kept for the next reach, together with a property that is set during the reach.
func test_adaptation() -> void:
	var plate := new_plate()
	check_equal(plate.begin_for(plate.add_real_target("real", -5.0, 0.1), plate.add_virtual_target("felt", 5.0, 0.1), 0.0), OK, "begin")
	for frame in 270:
		plate.update(Vector3(0, 0, 0.05 - frame * 0.1 / 270), frame * 11111111)
	plate.horizon = 4
	check_equal(plate.end(), OK, "end")
	check_equal(plate.horizon, 4, "the property")
	# The values differ slightly, because the property is from a second pass of the filter over the motion.
	check_near(plate.tactile_weight, plate.get_summary().tactile_weight, "the estimate of the reach is carried over", 0.002)
	check(plate.tactile_weight != 0.2, "the estimate has changed")

func test_places() -> void:
	var plate := new_plate()
	var nodes: Array[HapticTarget] = []
	for role: HapticTarget.Role in [HapticTarget.Role.REAL, HapticTarget.Role.VIRTUAL]:
		var node := HapticTarget.new()
		node.name = "target %d" % role
		node.role = role
		node.plate = plate
		add_child(node)
		node.position = Vector3(0.01 - 0.02 * role, 0, -0.05)
		nodes.append(node)
	check_equal(plate.begin(nodes[0].place(), nodes[1].place()), OK, "begin with targets of the scene")
	plate.cancel()
	nodes[1].position.x = 0.02
	check_equal(nodes[1].place(), plate.find_target("target 1"), "the same target, moved")
	check(plate.get_gap(nodes[0].place(), nodes[1].place()).gap_deg < 0, "the gap after the target was moved")
	nodes[1].free()
	refused("no target has the name", plate.find_target.bind("target 1"))
	check_equal(plate.start_recording("user://reach.csv"), OK, "a recording below user://")
	check_equal(plate.get_recording_status().rows_lost, 0, "status")
	check_equal(plate.stop_recording(), OK, "its end")
	check_equal(refused("stop_recording", plate.stop_recording), ERR_UNAVAILABLE, "stop twice")
	check_equal(refused("start_recording", plate.start_recording.bind("/nowhere/recording.csv")), ERR_FILE_CANT_OPEN, "no such folder")
	check(FileAccess.get_file_as_string("user://reach.csv").begins_with("# haptic retargeting recording"), "its file")
	refused(ProjectSettings.globalize_path("res://none.gltf"), plate.load_scene.bind("res://none.gltf"))
	nodes[0].free()

# A node destroys its session when it is freed. A process can have 1024 sessions (HRT_SESSIONS_MAX).
func test_lifetime() -> void:
	for i in 1100:
		var plate := HapticRetargeting.new()
		check(plate.add_real_target("real", 0.0, 0.1) != 0, "session %d" % i)
		plate.free()
	check(new_plate().get_version().begins_with("0."), "version")

# Checks of the class HapticRetargeting as a script meets it. Prints PASS and their number, or FAIL and what for. A
# line "error: TEXT" announces an error that the engine is to print.
extends Node

const HRT = preload("res://addons/haptic_retargeting/constants.gd")
const Plate = preload("res://addons/haptic_retargeting/haptic_retargeting.gdns")

var checks = 0
var failures = 0
var heard = []

func _ready():
	check_properties()
	check_names()
	check_axes()
	check_signals()
	check_refusals()
	check_adaptation_and_profile()
	check_calibration()
	check_recording()
	check_scene_and_assignment()
	check_registration()
	check_fingertip()
	check_scenario()
	check_freed()
	print("FAIL %d of %d" % [failures, checks] if failures else "PASS %d" % checks)
	get_tree().quit(1 if failures else 0)

func check(right, what):
	checks += 1
	if not right:
		failures += 1
		print("FAIL: ", what)

func check_equal(value, wanted, what):
	check(typeof(value) == typeof(wanted) and value == wanted, "%s is %s; wanted %s" % [what, value, wanted])

func check_near(value, wanted, what):
	check(abs(value - wanted) < 1e-4, "%s is %s; wanted %s" % [what, value, wanted])

func expect_error(text):
	print("error: ", text)

func new_plate():
	var plate = Plate.new()
	add_child(plate)
	return plate

func check_properties():
	var plate = $Plate
	check_equal(plate.get_class(), "Spatial", "class")
	check_equal(plate.horizon, 7, "horizon of the scene")
	check_equal(plate.plate_bound_deg, 60.5, "bound of the scene")
	check_equal(plate.start_position_m, Vector3(0, 0, 0.0625), "start of the scene")
	check_equal(plate.step_period_ns, 100000000, "default step period")
	check_equal(plate.tactile_weight, 0.2, "default tactile weight, a double")
	plate.perceived_weight = 2
	check_equal(plate.perceived_weight, 2.0, "a whole number in place of a float")
	var listed = {}
	for property in plate.get_property_list():
		listed[property.name] = property
	check_equal(listed["control"].hint_string, "MPC,Fixed Plate", "what the inspector offers for control")
	check_equal(listed["tactile_weight"].type, TYPE_REAL, "type of tactile_weight")
	expect_error("horizon was given a value of type String; allowed: int from 0 to 4294967295")
	plate.horizon = "three"
	expect_error("horizon was given a value of type int; allowed: int from 0 to 4294967295")
	plate.horizon = -1
	check_equal(plate.horizon, 7, "horizon after what it cannot take")
	plate.plate_bound_deg = 91.0
	expect_error("plate_bound_deg is 91; allowed: 0.1 to 90")
	check_equal(plate.add_real_target("real", 0.0, 0.1), 0, "a target while a property is out of range")
	plate.plate_bound_deg = 84.5
	plate.plate_upper_stop_deg = 90
	plate.plate_lower_stop_deg = -90
	check(plate.add_real_target("real", 0.0, 0.1) != 0, "stops may be set one after the other")

func check_names():
	var plate = new_plate()
	expect_error("hrt_target_add")
	check_equal(plate.add_real_target("n".repeat(64), 0.0, 0.1), 0, "a name of 64 bytes")
	check(plate.add_real_target("n".repeat(63), 0.0, 0.1) != 0, "a name of 63 bytes")

# Godot's axes are the plate's: x right, y up, -z away. A plate that is turned and moved, with the finger on it,
# gives the same commands as one at the origin.
func check_axes():
	var plate = new_plate()
	var left = plate.add_real_target_at("left", Vector3(-0.1, 0.02, 0.05))
	var ahead = plate.add_virtual_target_at("ahead", Vector3(0, 0, -0.05))
	check_near(plate.get_authority(left, ahead).gap_deg, -90.0, "gap from left (+90) to ahead (0)")

	var turned = new_plate()
	turned.rotation_degrees = Vector3(20, 125, -7)
	turned.translation = Vector3(1.5, 0.75, -2.25)
	var outputs = []
	for each in [new_plate(), turned]:
		var pose = each.global_transform
		var real = each.add_real_target_at("real", pose.xform(Vector3(-0.01, 0, -0.05)))
		var felt = each.add_virtual_target_at("felt", pose.xform(Vector3(0.005, 0, -0.05)))
		check_equal(each.begin(real, felt), OK, "begin")
		for frame in 270:
			check_equal(each.update(pose.xform(Vector3(-0.00003 * frame, 0.002, 0.05 - frame * 0.1 / 270)),
					frame * 11111111), OK, "update")
		outputs.append(each.get_command())
		check_equal(each.end(), OK, "end")
	check(outputs[0].finger_direction_deg > 2, "a finger that goes left has a positive direction")
	check(outputs[0].plate_orientation_deg < -5, "the plate turns right to send the hand left of what is felt")
	for field in outputs[0]:
		check(abs(outputs[0][field] - outputs[1][field]) < 0.01, "%s is %s, on the turned plate %s" % [field,
				outputs[0][field], outputs[1][field]])

	turned.scale = Vector3(2, 2, 2)
	expect_error("the node is scaled, sheared or mirrored in the world")
	check_equal(turned.begin(1, 2), ERR_PARAMETER_RANGE_ERROR, "begin on a scaled plate")

func hear(argument, name):
	heard.append([name, argument])

func check_signals():
	var plate = new_plate()
	for name in ["plate_commanded", "flags_changed", "reach_ended"]:
		check_equal(plate.connect(name, self, "hear", [name]), OK, "connect " + name)
	var real = plate.add_real_target("real", -5.0, 0.1)
	var felt = plate.add_virtual_target("felt", 5.0, 0.1)
	check_equal(plate.is_reaching(), false, "reaching before")
	check(plate.get_command().empty(), "command before")
	check_equal(plate.begin_with_plate_at(real, felt, 12.5), OK, "begin")
	check_equal(plate.is_reaching(), true, "reaching")
	plate.update_sample(HRT.SAMPLE_DIRECTION, 0, 0.0, 0.0, 0.0, 0.0, 0.0)
	plate.update_sample(HRT.SAMPLE_DIRECTION, 50000000, 0.0, 0.0, 0.0, 0.0, 0.0)
	check_equal(heard.size(), 1, "signals of a step and of a sample between steps")
	check_equal(heard[0][0], "plate_commanded", "signal")
	check_equal(heard[0][1], plate.get_command().plate_orientation_deg, "its argument")
	check(plate.get_command().flags & HRT.COMMAND_HELD != 0, "the flag HELD between steps")
	heard.clear()
	check_equal(plate.update_lost(250000000), OK, "a dropout")
	check(heard.size() > 0 and heard[0][0] == "flags_changed" and heard[0][1] & HRT.COMMAND_PREDICTED != 0,
			"flags_changed with PREDICTED after a dropout: %s" % [heard])
	heard.clear()
	check_equal(plate.end(), OK, "end")
	check_equal(heard, [["reach_ended", plate.get_summary().final_miss_deg]], "signals of the end")
	check_equal(plate.get_summary().samples, 3, "samples")

func check_refusals():
	var plate = new_plate()
	expect_error("hrt_reach_update")
	check_equal(plate.update_lost(0), ERR_DOES_NOT_EXIST, "update without a session")
	var real = plate.add_real_target("real", -5.0, 0.1)
	var felt = plate.add_virtual_target("felt", 5.0, 0.1)
	check(plate.get_summary().empty(), "summary without a reach")
	check_equal(plate.begin(real, felt), OK, "begin")
	check_equal(plate.update(Vector3(), 1000), OK, "update")
	expect_error("hrt_reach_update")
	check_equal(plate.update(Vector3(), 999), ERR_INVALID_DATA, "time that runs backwards")
	expect_error("hrt_reach_update")
	check_equal(plate.update(Vector3(NAN, 0, 0), 2000), ERR_PARAMETER_RANGE_ERROR, "not a number")
	expect_error("called with (Vector3); it is update(world_position: Vector3, time_ns: int)")
	check_equal(plate.update(Vector3()), ERR_INVALID_PARAMETER, "an argument too few")
	expect_error("called with (String, int); it is update(world_position: Vector3, time_ns: int)")
	check_equal(plate.update("here", 2000), ERR_INVALID_PARAMETER, "an argument of another type")
	expect_error("called with (null, int); it is update(world_position: Vector3, time_ns: int)")
	check_equal(plate.update(self, 2000), ERR_INVALID_PARAMETER, "an argument of a type that no method takes")
	expect_error("called with (int, int, int, int, int, int, int, int); it is update_sample(flags: int")
	check_equal(plate.callv("update_sample", range(20)), ERR_INVALID_PARAMETER, "far too many arguments")
	expect_error("flags 16; allowed: sums of 1 direction")
	check_equal(plate.update_sample(16, 2000, 0.0, 0.0, 0.0, 0.0, 0.0), ERR_INVALID_PARAMETER, "flags")
	check_equal(plate.update(Vector3(), 2000), OK, "update after refusals")
	plate.horizon = 5
	check_equal(plate.update(Vector3(), 3000), OK, "a property set during a reach waits")
	check_equal(plate.end(), OK, "end")
	check_equal(plate.begin(real, felt), OK, "begin with the property")

func check_adaptation_and_profile():
	var plate = new_plate()
	plate.tactile_weight = 0.2
	var profile = plate.save_profile()
	check_near(JSON.parse(profile).result.tactile_weight, 0.2, "tactile weight in the profile")
	var other = new_plate()
	check_equal(other.load_profile(profile), OK, "load")
	check_equal(other.tactile_weight, 0.2, "tactile weight from the profile")
	expect_error("hrt_profile_load")
	check_equal(other.load_profile("{"), ERR_PARSE_ERROR, "half a profile")

	plate.adaptation = HRT.ADAPTATION_CARRIED
	plate.begin(plate.add_real_target("real", -5, 0.1), plate.add_virtual_target("felt", 5, 0.1))
	for frame in 270:
		plate.update(Vector3(0, 0, 0.05 - frame * 0.1 / 270), frame * 11111111)
	plate.horizon = 4
	plate.end()
	check_equal(plate.horizon, 4, "a property set during a reach that learns")
	check_equal(plate.tactile_weight, plate.get_summary().tactile_weight, "what a reach has learnt, carried")
	check(plate.tactile_weight != 0.2, "something is learnt")

# A simulated user whose share of touch is known slides over a plate at rest.
func check_calibration():
	var plate = new_plate()
	expect_error("hrt_calibration_begin_trial")
	check_equal(plate.begin_trial(0), ERR_DOES_NOT_EXIST, "a trial without a calibration")
	check_equal(plate.begin_calibration(0), OK, "begin")
	expect_error("hrt_calibration_solve")
	check(plate.solve_calibration().empty(), "a solution without trials")
	expect_error("apply_calibration: no calibration is solved")
	check_equal(plate.apply_calibration(), ERR_UNAVAILABLE, "nothing to apply")
	var random = RandomNumberGenerator.new()
	random.seed = 1
	for round_of_trials in 4:
		for plate_deg in [-60.0, -30.0, 0.0, 30.0, 60.0]:
			slide(plate, plate_deg, random)
	check_equal(plate.begin_trial(0), OK, "a trial more")
	check_equal(plate.cancel_trial(), OK, "and not")
	var found = plate.solve_calibration()
	check_equal(found.trials_used, 20, "trials used")
	check(found.tactile_weight_lower < 0.15 and 0.15 < found.tactile_weight_upper,
			"the interval of the tactile weight: %s" % [found])
	check(found.tactile_weight_upper - found.tactile_weight_lower < 0.1, "is narrow: %s" % [found])
	check_equal(found.tactile_weight_known, 1, "known")
	check(abs(plate.get_next_angle().plate_orientation_deg) <= 75, "the next angle")
	check_equal(plate.get_slide(0).trial, 0, "a slide")
	check_equal(plate.set_conditions("desk 1", "Ultraleap", 1767225600), OK, "conditions")
	check_equal(plate.apply_calibration(), OK, "apply")
	check_equal(plate.set_conditions("desk 2", "Ultraleap", 0), OK, "other conditions")
	check_equal(plate.get_conditions().differing, 1, "another plate")
	check_equal(plate.get_conditions().time_s, 1767225600, "when")
	check_equal(plate.tactile_weight, found.tactile_weight, "tactile weight, applied")
	check_equal(plate.bias_deg, found.bias_deg, "bias, applied")
	expect_error("compare_calibrations: it needs two calibrations")
	check(plate.compare_calibrations().empty(), "one calibration is no comparison")
	check_equal(plate.begin_calibration(0), OK, "a second calibration")
	for round_of_trials in 4:
		for plate_deg in [-60.0, -30.0, 0.0, 30.0, 60.0]:
			slide(plate, plate_deg, random)
	var again = plate.solve_calibration()
	var change = plate.compare_calibrations()
	check_near(change.tactile_weight, again.tactile_weight - found.tactile_weight, "test and retest")
	check_equal(change.differing & HRT.DIFFERS_TACTILE_WEIGHT, 0, "the same user")
	check_equal(plate.end_calibration(), OK, "end")
	expect_error("hrt_calibration_destroy")
	check_equal(plate.end_calibration(), ERR_DOES_NOT_EXIST, "end twice")

func slide(plate, plate_deg, random):
	var user = preload("res://user.gd").new(0.0)
	var finger = Vector3(0, 0.002, 0.05)
	check_equal(plate.begin_trial(plate_deg), OK, "begin of a trial")
	for frame in 315:
		var seconds = frame / 90.0 - 0.5
		if seconds > 0:
			var step = user.next_step_s
			user.feel_until(seconds, plate_deg)
			if user.next_step_s != step:
				user.direction_deg += random.randfn(0, 0.7)
			finger += Vector3(0, 0, -1).rotated(Vector3.UP, deg2rad(user.direction_deg)) * 0.1 / 270
		var seen = finger + Vector3(random.randfn(0, 0.0003), 0, random.randfn(0, 0.0003))
		check_equal(plate.add_trial_sample(seen, frame * 11111111), OK, "sample")
	check_equal(plate.end_trial(), OK, "end of a trial")

func check_recording():
	var plate = new_plate()
	var path = OS.get_user_data_dir() + "/recording.csv"
	check_equal(plate.start_recording(path), OK, "start")
	plate.begin(plate.add_real_target("real", -5, 0.1), plate.add_virtual_target("felt", 5, 0.1))
	plate.update(Vector3(), 0)
	plate.end()
	check_equal(plate.stop_recording(), OK, "stop")
	var file = File.new()
	check_equal(file.open(path, File.READ), OK, "open")
	check_equal(file.get_line(), "# haptic retargeting recording, version 3", "first line")
	expect_error("hrt_recording_stop")
	check_equal(plate.stop_recording(), ERR_UNAVAILABLE, "stop twice")
	expect_error("hrt_recording_start")
	check_equal(plate.start_recording("/nowhere/recording.csv"), ERR_FILE_CANT_WRITE, "a folder that is not there")

# The apparatus of the desk stands at (0.12, 0.75, -0.32), turned by 20 degrees to the left.
func check_scene_and_assignment():
	var plate = new_plate()
	var desk = OS.get_environment("HRT_BINDINGS") + "/../../samples/scenes/desk.gltf"
	check_equal(plate.load_scene(desk), OK, "scene")
	check((plate.translation - Vector3(0.12, 0.75, -0.32)).length() < 1e-6, "the plate's place: %s" % plate.translation)
	check(abs(plate.rotation_degrees.y - 20) < 1e-4, "the plate's turn: %s" % plate.rotation_degrees)
	var cylinder = plate.find_target("cylinder")
	var bottle = plate.find_target("bottle")
	check(cylinder != 0 and bottle != 0, "targets of the scene")
	expect_error("hrt_target_find")
	check_equal(plate.find_target("teapot"), 0, "a target that is not there")
	expect_error("get_assigned: no assignment")
	check(plate.get_assigned(bottle).empty(), "no assignment yet")
	check_equal(plate.assign_targets(false), OK, "assignment")
	check_equal(plate.get_assigned(bottle).real_target, cylinder, "assigned")
	check_equal(plate.begin(cylinder, bottle), OK, "begin")
	expect_error("hrt_scene_register: a reach is under way")
	check_equal(plate.load_scene(desk), ERR_UNAVAILABLE, "a scene during a reach")
	check_equal(plate.cancel(), OK, "cancel")
	expect_error("hrt_scene_register")
	check_equal(plate.load_scene(desk), ERR_ALREADY_EXISTS, "the same names again")

func touch_marks(plate, pose):
	for mark in [Vector3(0, 0, 0.05), Vector3(0.076, 0, 0.044), Vector3(0.076, 0, -0.044), Vector3(-0.076, 0, -0.044),
			Vector3(-0.076, 0, 0.044)]:
		check_equal(plate.add_mark_touch(mark, pose.xform(mark)), OK, "touch")

func check_registration():
	var plate = new_plate()
	var pose = Transform(Basis(Vector3.UP, deg2rad(70)), Vector3(0.3, 0.75, -0.4))
	expect_error("apply_registration: nothing is fitted")
	check_equal(plate.apply_registration(0), ERR_UNAVAILABLE, "nothing to apply")
	check_equal(plate.fit_registration().verdict, HRT.REGISTRATION_TOO_FEW, "no touches")
	check(plate.get_registration_advice().length() > 10, "advice")
	touch_marks(plate, pose)
	var found = plate.fit_registration()
	check_equal(found.verdict, HRT.REGISTRATION_HOLDS, "verdict")
	check((found.plate_position_m - pose.origin).length() < 1e-6, "place: %s" % found.plate_position_m)
	check_equal(plate.apply_registration(5000000), OK, "apply")
	check(plate.global_transform.is_equal_approx(pose), "the node is at the plate: %s" % plate.global_transform)
	var start = Vector3(0, 0, 0.05)
	var good = plate.confirm_registration(start, pose.xform(start), 6000000)
	check_equal(good.holds, 1, "a touch that agrees")
	check_equal(plate.registration_time_ns, 6000000, "counts")
	check_equal(plate.flags & HRT.SESSION_REGISTERED, HRT.SESSION_REGISTERED, "registered")
	check_equal(plate.confirm_registration(start, Vector3(), 7000000).holds, 0, "a touch that does not")
	check_equal(plate.flags & HRT.SESSION_REGISTERED, 0, "unregistered")
	check_equal(plate.apply_registration(8000000), OK, "apply again")
	plate.translate(Vector3(0.01, 0, 0))
	expect_error("hrt_registration_confirm")
	check(plate.confirm_registration(start, pose.xform(start), 9000000).empty(), "a plate that was moved")
	check_equal(plate.flags & HRT.SESSION_REGISTERED, 0, "ends the registration")

# A joint 8 mm above the skin and 5 mm behind it, which touches one mark in several ways.
func check_fingertip():
	var plate = new_plate()
	var offset = Vector3(0, -0.008, -0.005)
	var mark = Vector3(0.3, 0.75, -0.4)
	expect_error("place_fingertip: nothing is fitted")
	check(is_nan(plate.place_fingertip(Transform()).x), "no offset yet")
	var joints = []
	for turn in [Vector3(), Vector3(0.7, 0, 0), Vector3(-0.6, 0, 0), Vector3(0, 0.8, 0), Vector3(0, 0, 0.6), Vector3(0, -0.7, -0.5)]:
		var basis = Basis(turn)
		joints.append(Transform(basis, mark - basis.xform(offset)))
		check_equal(plate.add_joint_touch(joints[-1]), OK, "touch by a joint")
	var fingertip = plate.fit_fingertip()
	check_equal(fingertip.known, 1, "the offset")
	check((fingertip.offset_m - offset).length() < 1e-5, "offset: %s" % fingertip.offset_m)
	for joint in joints:
		check((plate.place_fingertip(joint) - mark).length() < 1e-5, "the skin: %s" % plate.place_fingertip(joint))

# Nodes end their sessions, of which a process has 64.
func check_freed():
	for i in 200:
		var plate = Plate.new()
		check(plate.add_real_target("real", 0.0, 0.1) != 0, "session %d" % i)
		plate.free()
	check_equal(new_plate().get_version(), "0.3.0", "version")

# What all hosts play (tests/bindings/scenario.txt), by the node's methods.
func check_scenario():
	var plate = new_plate()
	var targets = {}
	var saved = ""
	var file = File.new()
	check_equal(file.open(OS.get_environment("HRT_SCENARIO"), File.READ), OK, "the scenario")
	var played = 0
	while not file.eof_reached():
		var line = file.get_line()
		if line == "" or line[0] == "#":
			continue
		played += 1
		var refused = line.split(" ! ")
		var gives = refused[0].split(" -> ")
		var name = gives[0].split(" ")[0]
		var a = pairs(gives[0].substr(name.length()))
		if refused.size() > 1:
			expect_error(refused[1].split(" ", true, 1)[1])
		var gave = OK
		match name:
			"configure": plate.tactile_weight = float(a.tactile_weight)
			"target":
				var id = plate.call("add_%s_target" % a.role, a.name, number(a.direction_deg), number(a.distance_m))
				gave = OK if id != 0 else FAILED
				if id != 0:
					targets[a.name] = id
			"remove": gave = plate.remove_target(targets[a.name])
			"authority": gave = plate.get_authority(targets[a.real], targets[a.virtual])
			"best": gave = plate.get_best_authority(targets[a.virtual])
			"begin": gave = plate.begin(targets[a.real], targets[a.virtual])
			"retarget": gave = plate.retarget(targets[a.real], targets[a.virtual])
			"update": gave = plate.update(place(a.at), int(a.time_ns))
			"lost":
				gave = plate.update_lost(int(a.time_ns))
				if gave == OK:
					gave = plate.get_command()
			"slide":
				for i in int(a.frames):
					var share = i / (float(a.frames) - 1)
					gave = plate.update(Vector3(0, 0, 0.05).linear_interpolate(place(a.to), share), i * 11111111)
			"cancel": gave = plate.cancel()
			"end":
				gave = plate.end()
				if gave == OK:
					gave = plate.get_summary()
			"save_profile": saved = plate.save_profile()
			"load_profile": gave = plate.load_profile(a.text if "text" in a else saved)
			"touch": gave = plate.add_mark_touch(place(a.mark), place(a.at))
			"register":
				gave = plate.fit_registration()
				for axis in ["x", "y", "z"]:
					gave[axis] = gave.plate_position_m[axis]
			_: check(false, "a call of the scenario: " + name)
		var failed = gave.empty() if gave is Dictionary else gave != OK
		check_equal(failed, refused.size() > 1, line)
		if gives.size() > 1 and not failed:
			var wanted = pairs(gives[1])
			for key in wanted:
				if key == "flags":
					check(gave.flags & int(wanted.flags) != 0, line)
				else:
					check_near(float(gave[key]), float(wanted[key]), line)
	check(played > 40, "the scenario was played")

func pairs(words):
	var found = {}
	for word in words.split(" ", false):
		var pair = word.split("=", true, 1)
		found[pair[0]] = pair[1]
	return found

func number(text):
	return NAN if text == "nan" else float(text)

func place(text):
	var parts = text.split(",")
	return Vector3(number(parts[0]), number(parts[1]), number(parts[2]))

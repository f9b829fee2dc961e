# Tests set-ups, with a simulated user who follows each step.
extends "res://tests/checks.gd"

const FRAME_NS := 11111111

var steps: Array[Dictionary] = []
var results: Array[Dictionary] = []
var time_ns := 0

func set_up_plate() -> HapticRetargeting:
	var plate := new_plate()
	plate.setup_step.connect(func(step: Dictionary) -> void: steps.append(step))
	plate.setup_finished.connect(func(result: Dictionary) -> void: results.append(result))
	return plate

# Touches the marks of a plate at `pose`, until the set-up is over.
func touch_marks(plate: HapticRetargeting, pose: Transform3D) -> Dictionary:
	var shown := 0
	var lifted := 0  # number of remaining frames
	for frame in 3000:
		var step := steps[-1] if steps else {"place_m": Vector3(), "part": 0, "number": 0, "instruction": -1}
		if shown != steps.size() and step.instruction == HapticRetargeting.STEP_TOUCH_MARK:
			lifted = 8
		shown = steps.size()
		lifted -= 1
		var turned := Basis.from_euler(SimulatedFinger.TURNS[step.number % 6] if step.part == HapticRetargeting.SETUP_FINGERTIP else Vector3())
		var skin: Vector3 = pose * step.place_m + (Vector3(0, 0.05, 0) if lifted > 0 else Vector3())
		time_ns += FRAME_NS
		check_equal(plate.update_joint(Transform3D(turned, skin - turned * SimulatedFinger.SKIN), time_ns), OK, "update")
		if not plate.is_setting_up():
			return results[-1]
	check(false, "the set-up does not end: %s" % [steps[-1]])
	return {}

func test_registration() -> void:
	var plate := set_up_plate()
	var pose := Transform3D(Basis(Vector3.UP, deg_to_rad(70)), Vector3(0.3, 0.75, -0.4))
	check_equal(refused("what is 0", plate.begin_setup.bind(0)), ERR_PARAMETER_RANGE_ERROR, "nothing to set up")
	check_equal(refused("what is", plate.begin_setup.bind(-1)), ERR_PARAMETER_RANGE_ERROR, "a negative number")
	check_equal(refused("begin_setup", plate.begin_setup.bind(HapticRetargeting.SETUP_CHECK)), ERR_UNAVAILABLE, "no registration yet")
	plate.setup_touches_per_mark = 9
	check_equal(refused("touches_per_mark is 9; allowed: 1 to 5", plate.begin_setup.bind(HapticRetargeting.SETUP_REGISTRATION)),
			ERR_PARAMETER_RANGE_ERROR, "a property of set-ups")
	plate.setup_touches_per_mark = 1
	check_equal(plate.begin_setup(HapticRetargeting.SETUP_FINGERTIP | HapticRetargeting.SETUP_REGISTRATION), OK, "begin")
	check(plate.is_setting_up(), "under way")
	var found := touch_marks(plate, pose)
	check_equal(found.done, HapticRetargeting.SETUP_FINGERTIP | HapticRetargeting.SETUP_REGISTRATION, "done")
	check_equal(results.size(), 1, "signals of the end")
	check(steps.size() > 20 and steps.size() < 80, "signals of steps: %d" % steps.size())
	check_equal(steps[0].text, "Lift your finger. Then touch mark 1 with the finger held flat, and hold still.", "the first instruction")
	check(plate.global_transform.is_equal_approx(pose), "the node is at the plate: %s" % plate.global_transform)
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, HapticRetargeting.SESSION_REGISTERED, "registered")

	check_equal(plate.begin_setup(HapticRetargeting.SETUP_CHECK), OK, "a check")
	check_equal(touch_marks(plate, pose).done, HapticRetargeting.SETUP_CHECK, "the check finds the plate at its pose")
	check_equal(plate.begin_setup(HapticRetargeting.SETUP_CHECK), OK, "another")
	check_near(touch_marks(plate, pose.translated(Vector3(0.03, 0, 0))).check_distance_m, 0.03, "a plate that was moved", 2e-3)
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, 0, "unregistered")

	check_equal(plate.begin_setup(HapticRetargeting.SETUP_REGISTRATION), OK, "a set-up")
	check_equal(plate.cancel_setup(), OK, "cancelled")
	check(not plate.is_setting_up(), "over")
	check_equal(refused("cancel_setup", plate.cancel_setup), ERR_UNAVAILABLE, "cancel twice")
	check_equal(plate.new_person(), OK, "another user")
	check_near(plate.tactile_weight, 0.2, "is not known", 1e-9)

# A registration ends when a script moves the node.
func test_moved_plate() -> void:
	var plate := set_up_plate()
	plate.begin_setup(HapticRetargeting.SETUP_REGISTRATION)
	touch_marks(plate, Transform3D(Basis(), Vector3(0, 0.7, 0)))
	plate.translate(Vector3(0.01, 0, 0))
	check_equal(refused("begin_setup", plate.begin_setup.bind(HapticRetargeting.SETUP_CHECK)), ERR_UNAVAILABLE, "not registered")
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, 0, "unregistered")

# A simulated person slides over a plate at rest.
func test_calibration() -> void:
	var plate := set_up_plate()
	plate.position = Vector3(0.3, 0.75, -0.4)
	var ahead := plate.add_virtual_target("ahead", 0.0, 0.1)
	check(is_nan(refused("person 0 does not exist", plate.update_simulated_finger.bind(0)).x), "no person yet")
	check_equal(plate.set_conditions("desk 1", "Ultraleap", 1767225600), OK, "conditions")
	check_equal(plate.begin_setup(HapticRetargeting.SETUP_CALIBRATION), OK, "begin")
	var resting := false
	var turns := []
	plate.plate_commanded.connect(func(orientation_deg: float) -> void: turns.append(orientation_deg))
	plate.begin_simulated_finger(ahead, 1)
	for frame in 40000:
		time_ns += FRAME_NS
		plate.update_simulated_finger(time_ns)
		var rests: bool = steps[-1].instruction == HapticRetargeting.STEP_REST_AT_START
		if rests and not resting:
			plate.begin_simulated_finger(ahead, 1)  # the next slide
		resting = rests
		if not plate.is_setting_up():
			break
	check_equal(results.size(), 1, "it ends")
	var found := results[0]
	check_equal(found.done, HapticRetargeting.SETUP_CALIBRATION, "done")
	check(found.slides >= 16 and turns.size() >= 16, "slides: %d, turns of the plate: %d" % [found.slides, turns.size()])
	check_equal(found.tactile_weight_known, 1, "the tactile weight is known")
	check(found.tactile_weight_lower < found.tactile_weight and found.tactile_weight < found.tactile_weight_upper, "its interval")
	check_equal(plate.tactile_weight, found.tactile_weight, "tactile weight, applied")
	check_equal(plate.set_conditions("desk 2", "Ultraleap", 0), OK, "other conditions")
	check_equal(plate.get_conditions(), {"differing": HapticRetargeting.CONDITION_PLATE, "time_s": 1767225600, "plate": "desk 1",
			"tracker": "Ultraleap"}, "another plate")

# A simulated person is steered to the real target.
func test_simulated_finger() -> void:
	var plate := reaching_plate()
	plate.position = Vector3(0.3, 0.75, -0.4)
	check_equal(refused("target", plate.begin_simulated_finger.bind(plate.find_target("real"), 1)), ERR_PARAMETER_RANGE_ERROR,
			"a simulated person cannot move to a real target")
	check_equal(plate.begin_simulated_finger(plate.find_target("felt"), 1), OK, "a person")
	var place := Vector3()
	for frame in 220:
		place = plate.update_simulated_finger(frame * FRAME_NS)
	check(place.distance_to(plate.position + Vector3(0.0087, 0, -0.0496)) < 0.006, "the hand is at the real target: %s" % place)

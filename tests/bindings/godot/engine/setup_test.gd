# Tests set-ups with the simulated person, whose plate is at PLATE in the world.
extends "res://tests/checks.gd"

const FRAME_NS := 11111111
const REGISTRATION := HapticRetargeting.SETUP_FINGERTIP | HapticRetargeting.SETUP_REGISTRATION
const PLATE := Vector3(0.3, 0.75, -0.4)

var steps: Array[Dictionary] = []
var results: Array[Dictionary] = []
var time_ns := 0

func set_up_plate() -> HapticRetargeting:
	var plate := new_plate()
	plate.setup_step.connect(func(step: Dictionary) -> void: steps.append(step))
	plate.setup_finished.connect(func(result: Dictionary) -> void: results.append(result))
	return plate

# Lets the simulated person follow a set-up, and returns its result.
func follow(plate: HapticRetargeting, what: int) -> Dictionary:
	check_equal(plate.begin_setup(what), OK, "begin")
	check(plate.is_setting_up(), "under way")
	check_equal(plate.begin_simulated_finger(0, 1), OK, "a person")
	for frame in 12000:
		if not plate.is_setting_up():
			return results[-1]
		time_ns += FRAME_NS
		check(plate.update_simulated_finger(time_ns).is_finite(), "update")
	check(false, "the set-up does not end: %s" % [steps[-1]])
	return {}

func test_registration() -> void:
	var plate := set_up_plate()
	check_equal(refused("what is 0", plate.begin_setup.bind(0)), ERR_PARAMETER_RANGE_ERROR, "nothing to set up")
	check_equal(refused("what is", plate.begin_setup.bind(-1)), ERR_PARAMETER_RANGE_ERROR, "a negative number")
	check_equal(refused("begin_setup", plate.begin_setup.bind(HapticRetargeting.SETUP_CHECK)), ERR_UNAVAILABLE, "no registration yet")
	plate.setup_touches_per_mark = 9
	check_equal(refused("touches_per_mark is 9; allowed: 1 to 5", plate.begin_setup.bind(REGISTRATION)), ERR_PARAMETER_RANGE_ERROR,
			"a property of set-ups")
	plate.setup_touches_per_mark = 1
	check_equal(follow(plate, REGISTRATION).done, REGISTRATION, "done")
	check_equal(results.size(), 1, "signals of the end")
	check(steps.size() > 20 and steps.size() < 80, "signals of steps: %d" % steps.size())
	check_equal(steps[0].text, "Lift your finger. Then touch mark 1 with the finger held flat, and keep it still.", "the first instruction")
	check(plate.position.distance_to(PLATE) < 0.003, "the node is at the plate: %s" % plate.position)
	check_near(plate.rotation_degrees.y, 20.0, "turned as the plate", 2.0)
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, HapticRetargeting.SESSION_REGISTERED, "registered")
	check_equal(follow(plate, HapticRetargeting.SETUP_CHECK).done, HapticRetargeting.SETUP_CHECK, "the check finds the plate at its pose")

	check_equal(plate.begin_setup(HapticRetargeting.SETUP_REGISTRATION), OK, "a set-up")
	check_equal(plate.update_joint(Transform3D(), time_ns), OK, "a tracked joint")
	check_equal(plate.cancel_setup(), OK, "cancelled")
	check(not plate.is_setting_up(), "over")
	check_equal(refused("cancel_setup", plate.cancel_setup), ERR_UNAVAILABLE, "cancel twice")
	check_equal(plate.new_person(), OK, "another user")
	check_near(plate.tactile_weight, 0.2, "the default weight", 1e-9)

	plate.translate(Vector3(0.01, 0, 0))  # a script that moves the node ends the registration
	check_equal(refused("begin_setup", plate.begin_setup.bind(HapticRetargeting.SETUP_CHECK)), ERR_UNAVAILABLE, "not registered")
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, 0, "unregistered")

func test_calibration() -> void:
	var plate := set_up_plate()
	check(is_nan(refused("person 0 does not exist", plate.update_simulated_finger.bind(0)).x), "no person yet")
	check_equal(refused("target", plate.begin_simulated_finger.bind(plate.add_real_target("real", -5.0, 0.1), 1)), ERR_PARAMETER_RANGE_ERROR,
			"a simulated person cannot move to a real target")
	check_equal(plate.set_conditions("desk 1", "Ultraleap", 1767225600), OK, "conditions")
	var turns := []
	plate.plate_commanded.connect(func(orientation_deg: float) -> void: turns.append(orientation_deg))
	var found := follow(plate, HapticRetargeting.SETUP_CALIBRATION)
	check_equal(found.done, HapticRetargeting.SETUP_CALIBRATION, "done")
	check(found.slides >= 16 and turns.size() >= 16, "slides: %d, turns of the plate: %d" % [found.slides, turns.size()])
	check_equal(found.tactile_weight_known, 1, "the tactile weight is known")
	check(found.tactile_weight_lower < found.tactile_weight and found.tactile_weight < found.tactile_weight_upper, "its interval")
	check_equal(plate.tactile_weight, found.tactile_weight, "tactile weight, applied")
	check_equal(plate.set_conditions("desk 2", "Ultraleap", 0), OK, "other conditions")
	check_equal(plate.get_conditions(), {"differing": HapticRetargeting.CONDITION_PLATE, "time_s": 1767225600, "plate": "desk 1",
			"tracker": "Ultraleap"}, "another plate")

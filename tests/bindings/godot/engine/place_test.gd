# Where things are: scenes, assignments, the plate's registration, the fingertip.
extends "res://tests/checks.gd"

const MARKS: Array[Vector3] = [Vector3(0, 0, 0.05), Vector3(0.076, 0, 0.044), Vector3(0.076, 0, -0.044),
		Vector3(-0.076, 0, -0.044), Vector3(-0.076, 0, 0.044)]

func test_scene() -> void:
	var plate := new_plate()
	var desk := OS.get_environment("HRT_DESK")
	check_equal(refused("hrt_scene_load", plate.load_scene.bind("/nowhere.gltf")), ERR_PARSE_ERROR, "no scene")
	check_equal(plate.load_scene(desk), OK, "scene")
	check(plate.position.is_equal_approx(Vector3(0.12, 0.75, -0.32)), "the node is at the plate: %s" % plate.position)
	check(plate.rotation_degrees.is_equal_approx(Vector3(0, 20, 0)), "turned as the plate: %s" % plate.rotation_degrees)
	check_equal(plate.plate_max_speed_deg_s, 400.0, "a property of the scene")
	var cylinder := plate.find_target("cylinder")
	var bottle := plate.find_target("bottle")
	check(cylinder != 0 and bottle != 0, "targets of the scene")
	check_equal(refused("find_target: no target has the name \"teapot\"", plate.find_target.bind("teapot")), 0, "a target that is not there")
	check(refused("get_assigned: no assignment", plate.get_assigned.bind(bottle)).is_empty(), "no assignment yet")
	check_equal(plate.assign_targets(false), OK, "assignment")
	check_equal(plate.get_assigned(bottle).real_target, cylinder, "assigned")
	check_near(plate.get_assigned(bottle).gap_deg, 6, "gap")
	check_equal(plate.assign_targets(true), OK, "exclusive assignment")
	var served := 0
	for target: String in ["bottle", "goblet", "pawn"]:
		served += plate.get_assigned(plate.find_target(target)).reachable
	check_equal(served, 1, "targets that the one real target serves")
	check_equal(plate.begin(cylinder, bottle), OK, "begin")
	check_equal(refused("hrt_scene_register: a reach is under way", plate.load_scene.bind(desk)), ERR_UNAVAILABLE,
			"a scene during a reach")
	check_equal(plate.cancel(), OK, "cancel")
	check_equal(refused("hrt_scene_register", plate.load_scene.bind(desk)), ERR_ALREADY_EXISTS, "the same names again")

func test_registration() -> void:
	var plate := new_plate()
	var pose := Transform3D(Basis(Vector3.UP, deg_to_rad(70)), Vector3(0.3, 0.75, -0.4))
	check_equal(refused("apply_registration: nothing is fitted", plate.apply_registration.bind(0)), ERR_UNAVAILABLE,
			"nothing to apply")
	check_equal(plate.fit_registration().verdict, HapticRetargeting.REGISTRATION_TOO_FEW, "no touches")
	check(plate.get_registration_advice().length() > 10, "advice")
	check_equal(plate.add_mark_touch(MARKS[0], Vector3(9, 9, 9)), OK, "a wrong touch")
	check_equal(plate.clear_touches(), OK, "clear")
	for mark in MARKS:
		check_equal(plate.add_mark_touch(mark, pose * mark), OK, "touch")
	var found := plate.fit_registration()
	check_equal(found.verdict, HapticRetargeting.REGISTRATION_HOLDS, "verdict")
	check(found.plate_position_m.distance_to(pose.origin) < 1e-6, "place: %s" % found.plate_position_m)
	check_equal(plate.apply_registration(5000000), OK, "apply")
	check(plate.global_transform.is_equal_approx(pose), "the node is at the plate: %s" % plate.global_transform)
	var start := MARKS[0]
	check_equal(plate.confirm_registration(start, pose * start, 6000000).holds, 1, "a touch that agrees")
	check_equal(plate.registration_time_ns, 6000000, "counts")
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, HapticRetargeting.SESSION_REGISTERED, "registered")
	check_equal(plate.confirm_registration(start, Vector3(), 7000000).holds, 0, "a touch that does not")
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, 0, "unregistered")
	check_equal(plate.apply_registration(8000000), OK, "apply again")
	plate.translate(Vector3(0.01, 0, 0))
	check(refused("hrt_registration_confirm", plate.confirm_registration.bind(start, pose * start, 9000000)).is_empty(),
			"a plate that was moved")
	check_equal(plate.flags & HapticRetargeting.SESSION_REGISTERED, 0, "ends the registration")

# A joint 8 mm above the skin and 5 mm behind it, which touches one mark in several ways.
func test_fingertip() -> void:
	var plate := new_plate()
	var offset := Vector3(0, -0.008, -0.005)
	var mark := Vector3(0.3, 0.75, -0.4)
	check(is_nan(refused("place_fingertip: nothing is fitted", plate.place_fingertip.bind(Transform3D())).x), "no offset yet")
	var joints: Array[Transform3D] = []
	for turn: Vector3 in [Vector3(), Vector3(0.7, 0, 0), Vector3(-0.6, 0, 0), Vector3(0, 0.8, 0), Vector3(0, 0, 0.6),
			Vector3(0, -0.7, -0.5)]:
		var turned := Basis.from_euler(turn)
		joints.append(Transform3D(turned, mark - turned * offset))
		check_equal(plate.add_joint_touch(joints[-1]), OK, "touch by a joint")
	var fingertip := plate.fit_fingertip()
	check_equal(fingertip.known, 1, "the offset")
	check(fingertip.offset_m.distance_to(offset) < 1e-5, "offset: %s" % fingertip.offset_m)
	for joint in joints:
		check(plate.place_fingertip(joint).distance_to(mark) < 1e-5, "the skin: %s" % plate.place_fingertip(joint))

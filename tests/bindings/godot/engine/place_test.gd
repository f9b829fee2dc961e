extends "res://tests/checks.gd"

func test_scene() -> void:
	var plate := new_plate()
	var desk := OS.get_environment("HRT_DESK")
	check_equal(refused("load_scene", plate.load_scene.bind("/nowhere.gltf")), ERR_FILE_CANT_OPEN, "no scene")
	check_equal(plate.load_scene(desk), OK, "scene")
	check(plate.position.is_equal_approx(Vector3(0.12, 0.75, -0.32)), "the node is at the plate: %s" % plate.position)
	check(plate.rotation_degrees.is_equal_approx(Vector3(0, 20, 0)), "turned as the plate: %s" % plate.rotation_degrees)
	check_equal(plate.plate_max_speed_deg_s, 400.0, "a property of the scene")
	var cylinder := plate.find_target("cylinder")
	var bottle := plate.find_target("bottle")
	check_equal(plate.get_served_by(bottle), cylinder, "the real target that the file names")
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
	check_equal(refused("load_scene: a reach is in progress", plate.load_scene.bind(desk)), ERR_UNAVAILABLE,
			"a scene during a reach")
	check_equal(plate.cancel(), OK, "cancel")
	check_equal(refused("load_scene", plate.load_scene.bind(desk)), ERR_ALREADY_EXISTS, "the same names again")

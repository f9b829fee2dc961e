extends "res://tests/checks.gd"

func test_scene_without_a_plate() -> void:
	var session: Node = load("res://main.tscn").instantiate()
	session.get_node("Desk").file = "res://tests/no_plate.gltf"
	refused("no node has a haptic role", add_child.bind(session))
	var board: Label3D = session.get_node("Wearer/Origin/Board")
	check_equal(board.text, "res://tests/no_plate.gltf is not a scene with a plate. See the log for the reason.\n", "board")
	check(not session.get_node("Desk/Plate").is_setting_up(), "it does not begin")

func test_headset_without_hand_tracking() -> void:
	var session: Node = load("res://main.tscn").instantiate()
	add_child(session)
	var board: Label3D = session.get_node("Wearer/Origin/Board")
	var asked := board.text
	session.finger = load("res://hand_finger.tscn").instantiate()
	add_child(session.finger)
	for i in 1000:
		session._process(0.02)
	check(board.text.begins_with("This headset tracks no hands."), board.text)
	check(board.text.ends_with(asked) and session.get_node("Desk/Plate").is_setting_up(), "it waits")

func test_finger_of_the_keys() -> void:
	var camera := Camera3D.new()
	add_child(camera)
	camera.look_at_from_position(Vector3(0, 0.4, 0), Vector3.ZERO, Vector3.FORWARD)
	var finger := MouseFinger.new(new_plate())
	add_child(finger)
	finger.advance(0)
	var before_m := finger.position.x
	Input.action_press("ui_right")
	Input.action_press("ui_select")
	finger.advance(500_000_000)
	Input.action_release("ui_right")
	Input.action_release("ui_select")
	check(finger.position.x > before_m + 0.01, "to the right")
	check_near(finger.position.y, MouseFinger.TOUCHING_M, "it touches")

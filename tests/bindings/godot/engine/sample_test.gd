# What the sample says where it cannot begin.
extends "res://tests/checks.gd"

func test_scene_without_a_plate() -> void:
	var session: Node = load("res://main.tscn").instantiate()
	session.get_node("Desk").file = "res://tests/no_plate.gltf"
	refused("no node has a haptic role", add_child.bind(session))
	var board: Label3D = session.get_node("Wearer/Origin/Board")
	check_equal(board.text, "res://tests/no_plate.gltf is no scene with a plate; the log says why.\n", "board")

func test_headset_without_hand_tracking() -> void:
	var hand: HandFinger = load("res://hand_finger.tscn").instantiate()
	add_child(hand)
	hand.advance(0)
	check(not hand.seen and hand.problem().begins_with("This headset tracks no hands."), hand.problem())

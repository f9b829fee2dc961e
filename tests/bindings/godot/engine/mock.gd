# Draws a session (the child Main, or the project's scene) only in a few frames after each 500th, which the mock runtime
# stores as a picture, and when the session is finished.
extends Node

const EVERY := 500
const AROUND := 4

var frames := 0

func _process(_delta: float) -> void:
	frames += 1
	var session := get_node("Main") if has_node("Main") else get_tree().current_scene
	var drawn: bool = frames % EVERY < AROUND or session._is_finished
	get_viewport().disable_3d = not drawn
	session.get_node("Wearer").render_target_update_mode = SubViewport.UPDATE_ALWAYS if drawn else SubViewport.UPDATE_DISABLED

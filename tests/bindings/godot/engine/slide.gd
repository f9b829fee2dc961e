# A finger that slides straight ahead for half a second by the clock, and then ends the program.
extends Node3D

var began_ms := Time.get_ticks_msec()
var frames := 0

func _process(_delta: float) -> void:
	var seconds := (Time.get_ticks_msec() - began_ms) / 1000.0
	position.z = 0.05 - 0.03 * seconds
	frames += 1
	if seconds > 0.5 and frames > 20:
		get_tree().quit(0)

## A tracked fingertip joint, whose position is that of this node. Each source of positions is a separate script.
class_name Finger
extends Node3D

## The session's instruction; a real user reads it on the board.
@warning_ignore("unused_signal") signal asked_for_step(step: Dictionary)
@warning_ignore("unused_signal") signal asked_to_touch(place: Vector3)
@warning_ignore("unused_signal") signal asked_to_slide(virtual_target: int)

## True while the joint is tracked.
var seen := true


## Moves this node to the tracked position at a time of the session.
func advance(_time_ns: int) -> void:
	pass


## Returns the reason for which it is not tracked, for the board.
func problem() -> String:
	return "" if seen else "Your hand is not tracked. The plate waits."


## Shows or hides the hand for the wearer. It is hidden in a reach, where it differs from the perceived position.
func show_to_wearer(shown: bool) -> void:
	for part: VisualInstance3D in find_children("*", "VisualInstance3D", true, false):
		part.layers = Desk.FOR_EVERYONE if shown else Desk.FOR_EXPERIMENTER

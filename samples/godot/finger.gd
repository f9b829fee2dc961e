## A node with the pose of a tracked joint at the fingertip. Each source of poses is a derived script.
class_name Finger
extends Node3D

## Instructions of the session for a simulated person. A real user reads them on the board.
@warning_ignore("unused_signal") signal asked_for_step(step: Dictionary)
@warning_ignore("unused_signal") signal asked_to_touch(position_m: Vector3)
@warning_ignore("unused_signal") signal asked_to_slide(virtual_target: int)

## True while the joint is tracked.
var seen := true


## Moves this node to the pose of the joint at a time of the session.
func advance(_time_ns: int) -> void:
	pass


## Returns the text for the board while the joint is not tracked; otherwise an empty text.
func problem() -> String:
	return "" if seen else "Your hand is not tracked. The plate waits."


## Shows or hides the hand for the wearer. The hand is hidden in a reach, because the wearer perceives it elsewhere.
func show_to_wearer(shown: bool) -> void:
	for part: VisualInstance3D in find_children("*", "VisualInstance3D", true, false):
		part.layers = Desk.FOR_EVERYONE if shown else Desk.FOR_EXPERIMENTER

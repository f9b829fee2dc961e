## A tracked fingertip joint: it is where this node is. Each source of it is a script of its own.
class_name Finger
extends Node3D

## What the session asks for; a real finger's owner reads it on the board.
@warning_ignore("unused_signal") signal asked_for_step(step: Dictionary)
@warning_ignore("unused_signal") signal asked_to_touch(place: Vector3)
@warning_ignore("unused_signal") signal asked_to_slide(virtual_target: int)

## Whether it is tracked now.
var seen := true


## Moves to where it is tracked at a time of the session.
func advance(_time_ns: int) -> void:
	pass


## Why it is not seen, for the board.
func problem() -> String:
	return "" if seen else "Your hand is not seen; the plate waits."


## The wearer does not see the hand in a reach: it goes elsewhere than it is felt to go.
func show_to_wearer(shown: bool) -> void:
	for part: VisualInstance3D in find_children("*", "VisualInstance3D", true, false):
		part.layers = Desk.FOR_EVERYONE if shown else Desk.FOR_EXPERIMENTER

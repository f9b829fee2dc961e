## A simulated person, who follows the session's instructions. Slides are the library's model, which feels the plate and is
## deflected by it. No real person took part.
class_name SimulatedFinger
extends Finger

## Offset from the tracked joint to the skin, in the joint's axes, which a set-up measures.
const SKIN := Vector3(0, -0.008, -0.012)
## Height of a lift, which a set-up detects in three frames, even at 5 frames a second.
const LIFT := Vector3(0, 0.12, 0)
const SPEED_M_S := 0.4
## SD of each coordinate, as for the library's person.
const TRACKER_NOISE_M := 0.0012
## Rotations of the joint for the touches that measure the offset of the skin.
const TURNS: Array[Vector3] = [Vector3(), Vector3(0.9, 0, 0), Vector3(-0.3, 0, 0.6), Vector3(-0.3, 0, -0.6),
		Vector3(-0.2, 0.7, 0), Vector3(-0.2, -0.7, 0)]
## Pose of the plate relative to its pose in the scene's file, which a set-up measures.
const DISPLACED := Transform3D(Basis(Vector3.UP, 0.07), Vector3(-0.02, 0, 0.015))

var _plate: HapticRetargeting
var _seed: int
var _stands: Transform3D
var _ahead: int
var _skin := LIFT  # position relative to the plate
var _way: Array[Vector3] = []  # next positions of the skin
var _turn := Vector3.ZERO
var _sliding := false
var _time_ns := 0
var _noise := RandomNumberGenerator.new()


func _init(plate: HapticRetargeting, seed_of_person: int) -> void:
	_plate = plate
	_seed = seed_of_person
	_noise.seed = seed_of_person
	_stands = plate.global_transform * DISPLACED.orthonormalized()
	_ahead = plate.add_virtual_target("ahead", 0.0, 0.1)
	add_child(preload("res://pointing_hand.tscn").instantiate())
	asked_for_step.connect(do_step)
	asked_to_touch.connect(func(place: Vector3) -> void: touch(_plate.to_local(place)))
	asked_to_slide.connect(slide)


## Follows a step of a set-up.
func do_step(step: Dictionary) -> void:
	var finds_skin: bool = step.part == HapticRetargeting.SETUP_FINGERTIP
	match step.instruction:
		HapticRetargeting.STEP_WAIT:
			_go([_skin * Vector3(1, 0, 1) + LIFT])
		HapticRetargeting.STEP_TOUCH_MARK:
			touch(step.place_m, TURNS[step.number % TURNS.size()] if finds_skin else Vector3.ZERO)
		HapticRetargeting.STEP_REST_AT_START:
			touch(step.place_m)
		HapticRetargeting.STEP_SLIDE:
			if step.part == HapticRetargeting.SETUP_GUIDES:
				_go([step.place_m])
			else:
				slide(_ahead)


## Lifts the finger, and touches a point of the plate.
func touch(place: Vector3, turn := Vector3.ZERO) -> void:
	_turn = turn
	_go([_skin * Vector3(1, 0, 1) + LIFT, place * Vector3(1, 0, 1) + LIFT, place])


func slide(virtual_target: int) -> void:
	_turn = Vector3.ZERO
	_way = []
	_sliding = _plate.begin_simulated_finger(virtual_target, _seed) == OK


func _go(way: Array[Vector3]) -> void:
	_sliding = false
	_way = way


func advance(time_ns: int) -> void:
	var step_m := SPEED_M_S * (time_ns - _time_ns) / 1e9
	_time_ns = time_ns
	if _way:
		_skin = _skin.move_toward(_way[0], step_m)
		if _skin == _way[0]:
			_way.pop_front()
	var tracked := _skin + TRACKER_NOISE_M * Vector3(_noise.randfn(), _noise.randfn(), _noise.randfn())
	if _sliding:
		_skin = _plate.to_local(_plate.move_simulated_finger(time_ns))  # includes tracker noise
		tracked = _skin
	var turned := _stands.basis * Basis.from_euler(_turn)
	global_transform = Transform3D(turned, _stands * tracked - turned * SKIN)

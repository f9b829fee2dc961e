## A simulated person, who follows the session's instructions. The plugin simulates slides, which the plate deflects.
class_name SimulatedFinger
extends Finger

## Offset from the tracked joint to the skin, in the axes of the joint. A set-up measures it.
const SKIN_OFFSET := Vector3(0, -0.008, -0.012)
## High enough that a set-up detects the lift even at 5 frames a second.
const LIFT := Vector3(0, 0.12, 0)
const SPEED_M_S := 0.4
## SD of the tracker noise of each coordinate, equal to that of the plugin's simulated person.
const TRACKER_NOISE_M := 0.0012
## Rotations of the joint in the touches that measure the offset of the skin.
const ROTATIONS: Array[Vector3] = [Vector3(), Vector3(0.9, 0, 0), Vector3(-0.3, 0, 0.6), Vector3(-0.3, 0, -0.6),
		Vector3(-0.2, 0.7, 0), Vector3(-0.2, -0.7, 0)]
## True pose of the plate relative to its pose in the scene's file. A set-up measures it.
const DISPLACED := Transform3D(Basis(Vector3.UP, 0.07), Vector3(-0.02, 0, 0.015))

var _plate: HapticRetargeting
var _seed: int
var _plate_pose: Transform3D
var _target_ahead: int
var _skin_position := LIFT  # in plate coordinates
var _waypoints: Array[Vector3] = []  # next positions of the skin
var _rotation_of_joint := Vector3.ZERO
var _sliding := false
var _time_ns := 0
var _noise := RandomNumberGenerator.new()


func _init(plate: HapticRetargeting, seed_of_person: int) -> void:
	_plate = plate
	_seed = seed_of_person
	_noise.seed = seed_of_person
	_plate_pose = plate.global_transform * DISPLACED.orthonormalized()
	_target_ahead = plate.add_virtual_target("ahead", 0.0, 0.1)
	add_child(preload("res://pointing_hand.tscn").instantiate())
	asked_for_step.connect(follow_step)
	asked_to_touch.connect(func(position_m: Vector3) -> void: touch(_plate.to_local(position_m)))
	asked_to_slide.connect(slide)


func follow_step(step: Dictionary) -> void:
	var measures_skin: bool = step.part == HapticRetargeting.SETUP_FINGERTIP
	match step.instruction:
		HapticRetargeting.STEP_WAIT:
			_move_along([_skin_position * Vector3(1, 0, 1) + LIFT])
		HapticRetargeting.STEP_TOUCH_MARK:
			touch(step.place_m, ROTATIONS[step.number % ROTATIONS.size()] if measures_skin else Vector3.ZERO)
		HapticRetargeting.STEP_REST_AT_START:
			touch(step.place_m)
		HapticRetargeting.STEP_SLIDE:
			if step.part == HapticRetargeting.SETUP_GUIDES:
				_move_along([step.place_m])
			else:
				slide(_target_ahead)


## Lifts the finger, and touches a point of the plate.
func touch(position_m: Vector3, rotation_of_joint := Vector3.ZERO) -> void:
	_rotation_of_joint = rotation_of_joint
	_move_along([_skin_position * Vector3(1, 0, 1) + LIFT, position_m * Vector3(1, 0, 1) + LIFT, position_m])


func slide(virtual_target: int) -> void:
	_rotation_of_joint = Vector3.ZERO
	_waypoints = []
	_sliding = _plate.begin_simulated_finger(virtual_target, _seed) == OK


func _move_along(waypoints: Array[Vector3]) -> void:
	_sliding = false
	_waypoints = waypoints


func advance(time_ns: int) -> void:
	var step_m := SPEED_M_S * (time_ns - _time_ns) / 1e9
	_time_ns = time_ns
	if _waypoints:
		_skin_position = _skin_position.move_toward(_waypoints[0], step_m)
		if _skin_position == _waypoints[0]:
			_waypoints.pop_front()
	var tracked := _skin_position + TRACKER_NOISE_M * Vector3(_noise.randfn(), _noise.randfn(), _noise.randfn())
	if _sliding:
		_skin_position = _plate.to_local(_plate.move_simulated_finger(time_ns))  # includes tracker noise
		tracked = _skin_position
	var joint_basis := _plate_pose.basis * Basis.from_euler(_rotation_of_joint)
	global_transform = Transform3D(joint_basis, _plate_pose * tracked - joint_basis * SKIN_OFFSET)

## The experimenter's view from above: the tracked path of the finger, and the estimate of the perceived path.
class_name Experimenter
extends Node3D

const MIN_STEP_M := 0.002
const RED := Color(0.9, 0.2, 0.15)
const BLUE := Color(0.2, 0.45, 0.95)
const FADED := Color(1, 1, 1, 0.3)

@onready var _camera: Camera3D = $Camera
@onready var _paths: Node2D = $Overlay/Paths
@onready var _text: Label = $Overlay/Text
@onready var _inset: TextureRect = $Overlay/Wearer
@onready var _tip: MeshInstance3D = $Tip
@onready var _perceived_tip: MeshInstance3D = $PerceivedTip
# Positions are in plate coordinates.
var _start: Vector3
var _perceived_position: Vector3
var _length_m := 0.0
var _true_path: Line2D
var _perceived_path: Line2D


func look_at_plate(plate: HapticRetargeting, wearer: Wearer) -> void:
	global_transform = plate.global_transform
	_inset.texture = wearer.get_texture()
	_inset.visible = not wearer.use_xr


func show_finger(position_m: Vector3) -> void:
	_tip.global_position = position_m


## Begins a new path, and fades the earlier ones.
func begin(start: Vector3) -> void:
	for path: Line2D in _paths.get_children():
		path.modulate = FADED
	_start = to_local(start)
	_perceived_position = _start
	_length_m = 0.0
	_true_path = _new_path(RED)
	_perceived_path = _new_path(BLUE)


## Adds a step to both paths for each 2 mm of distance from the start; the perceived one has the perceived direction.
func follow(finger: Vector3, perceived_deg: float) -> void:
	var step_m := _start.distance_to(to_local(finger)) - _length_m
	if step_m < MIN_STEP_M:
		return
	_length_m += step_m
	_perceived_position += Vector3.FORWARD.rotated(Vector3.UP, deg_to_rad(perceived_deg)) * step_m
	_true_path.add_point(_camera.unproject_position(finger))
	_perceived_path.add_point(_camera.unproject_position(to_global(_perceived_position)))
	_perceived_tip.position = _perceived_position


func report(text: String) -> void:
	_text.text = text


func save_picture(path: String) -> Error:
	for frame in 2:  # the paths are drawn in the second frame
		await RenderingServer.frame_post_draw
	return get_viewport().get_texture().get_image().save_png(path)


func _new_path(color: Color) -> Line2D:
	var path := Line2D.new()
	path.width = 3
	path.default_color = color
	_paths.add_child(path)
	return path

## The experimenter's flat view from above: the true position of the finger, and the controller's estimate of the perceived one.
class_name Experimenter
extends Node3D

const SHORTEST_STEP_M := 0.002
const RED := Color(0.9, 0.2, 0.15)
const BLUE := Color(0.2, 0.45, 0.95)
const FADED := Color(1, 1, 1, 0.3)

@onready var _camera: Camera3D = $Camera
@onready var _paths: Node2D = $Overlay/Paths
@onready var _text: Label = $Overlay/Text
@onready var _inset: TextureRect = $Overlay/Wearer
@onready var _tip: MeshInstance3D = $Tip
@onready var _felt_tip: MeshInstance3D = $FeltTip
# Position on the plate.
var _start: Vector3
var _felt_place: Vector3
var _way_m := 0.0
var _true_path: Line2D
var _felt_path: Line2D


func look_at_plate(plate: HapticRetargeting, wearer: Wearer) -> void:
	global_transform = plate.global_transform
	_inset.texture = wearer.get_texture()
	_inset.visible = not wearer.use_xr


func show_finger(place: Vector3) -> void:
	_tip.global_position = place


## Begins a path. Earlier paths fade.
func begin(start: Vector3) -> void:
	for path: Line2D in _paths.get_children():
		path.modulate = FADED
	_start = to_local(start)
	_felt_place = _start
	_way_m = 0.0
	_true_path = _new_path(RED)
	_felt_path = _new_path(BLUE)


## Adds a step to both paths: the perceived step has the same length, in the perceived direction.
func follow(finger: Vector3, felt_deg: float) -> void:
	var step_m := _start.distance_to(to_local(finger)) - _way_m
	if step_m < SHORTEST_STEP_M:
		return
	_way_m += step_m
	_felt_place += Vector3.FORWARD.rotated(Vector3.UP, deg_to_rad(felt_deg)) * step_m
	_true_path.add_point(_camera.unproject_position(finger))
	_felt_path.add_point(_camera.unproject_position(to_global(_felt_place)))
	_felt_tip.position = _felt_place


func report(text: String) -> void:
	_text.text = text


func save_picture(path: String) -> Error:
	for frame in 2:  # the first frame lays out the paths
		await RenderingServer.frame_post_draw
	return get_viewport().get_texture().get_image().save_png(path)


func _new_path(color: Color) -> Line2D:
	var path := Line2D.new()
	path.width = 3
	path.default_color = color
	_paths.add_child(path)
	return path

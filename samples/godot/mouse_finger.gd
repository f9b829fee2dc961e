## A finger for use without a headset. It follows the mouse in the view from above, or the arrow keys. It touches the
## plate while the left button or the space bar is pressed.
class_name MouseFinger
extends Finger

const TOUCHING_M := 0.002
const LIFTED_M := 0.05
## Speed on the screen while an arrow key is pressed.
const PIXELS_S := 150.0

var _plate: HapticRetargeting
var _at: Vector2
var _mouse := Vector2.INF
var _time_ns := 0


func _init(plate: HapticRetargeting) -> void:
	_plate = plate
	add_child(preload("res://pointing_hand.tscn").instantiate())


func advance(time_ns: int) -> void:
	var mouse := get_viewport().get_mouse_position()
	if mouse != _mouse:
		_mouse = mouse
		_at = mouse
	_at += Input.get_vector("ui_left", "ui_right", "ui_up", "ui_down") * PIXELS_S * (time_ns - _time_ns) / 1e9
	_time_ns = time_ns
	var touches := Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT) or Input.is_action_pressed("ui_select")
	var camera := get_viewport().get_camera_3d()
	var surface := Plane(_plate.global_basis.y, _plate.to_global(Vector3(0, TOUCHING_M if touches else LIFTED_M, 0)))
	var at: Variant = surface.intersects_ray(camera.project_ray_origin(_at), camera.project_ray_normal(_at))
	seen = at != null
	if seen:
		global_transform = Transform3D(_plate.global_basis, at)

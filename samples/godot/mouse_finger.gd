## A finger below the mouse, seen by the experimenter's camera from above; while the left button is pressed it touches. One tries
## the scene without a headset.
class_name MouseFinger
extends Finger

const TOUCHING_M := 0.002
const LIFTED_M := 0.05

var _plate: HapticRetargeting


func _init(plate: HapticRetargeting) -> void:
	_plate = plate
	add_child(preload("res://pointing_hand.tscn").instantiate())


func advance(_time_ns: int) -> void:
	var camera := get_viewport().get_camera_3d()
	var mouse := get_viewport().get_mouse_position()
	var height := TOUCHING_M if Input.is_mouse_button_pressed(MOUSE_BUTTON_LEFT) else LIFTED_M
	var surface := Plane(_plate.global_basis.y, _plate.to_global(Vector3(0, height, 0)))
	var at: Variant = surface.intersects_ray(camera.project_ray_origin(mouse), camera.project_ray_normal(mouse))
	seen = at != null
	if seen:
		global_transform = Transform3D(_plate.global_basis, at)

## The desk: the objects of a glTF file, and the ridged plate, which the plugin reads from the same file.
class_name Desk
extends Node3D

const RIDGE_PITCH_M := 0.004
## Layers of drawn objects: visible to everyone, and only to the experimenter.
const FOR_EVERYONE := 1
const FOR_EXPERIMENTER := 2

@export_file("*.gltf", "*.glb") var file := "res://desk.gltf"
## Real objects that are hidden from the wearer, who sees the virtual objects.
@export var hidden_from_wearer: PackedStringArray = ["cylinder"]

@onready var plate: HapticRetargeting = $Plate
@onready var _ridges: MultiMeshInstance3D = $Plate/Ridges
var _objects: Node3D
var _pose_in_plate: Transform3D


## Draws the objects, moves the node Plate to the plate's pose in the file, and adds the file's targets. Returns an error,
## or an empty text. Copies the file first, because the plugin cannot read files within an exported project.
func open() -> String:
	var copy := "user://desk." + file.get_extension()
	var written := FileAccess.open(copy, FileAccess.WRITE)
	if written == null:
		return "%s cannot be written: %s. Check the free space of the disk and the permissions." % [copy, error_string(FileAccess.get_open_error())]
	written.store_buffer(FileAccess.get_file_as_bytes(file))
	written.close()
	var document := GLTFDocument.new()
	var state := GLTFState.new()
	if document.append_from_file(copy, state) != OK or plate.load_scene(ProjectSettings.globalize_path(copy)) != OK:
		return "%s is not a scene with a plate. See the log for the reason." % file
	_objects = document.generate_scene(state)
	add_child(_objects)
	_pose_in_plate = plate.global_transform.affine_inverse()
	for target in hidden_from_wearer:
		(object(target) as VisualInstance3D).layers = FOR_EXPERIMENTER
	_make_ridges()
	plate.plate_commanded.connect(_rotate_ridges)
	return ""


func object(target: String) -> Node3D:
	return _objects.find_child(target.capitalize(), true, false)


## Marks the position to which the finger must move next, in plate coordinates.
func show_hint(position_m: Vector3) -> void:
	$Plate/Hint.position = position_m


## Moves the desk with the plate, because a registration moves the plate.
func _process(_delta: float) -> void:
	if _objects:
		_objects.global_transform = plate.global_transform * _pose_in_plate


## Godot's rotation about +Y is counter-clockwise seen from above, as is the plate orientation.
func _rotate_ridges(orientation_deg: float) -> void:
	_ridges.rotation_degrees.y = orientation_deg


func _make_ridges() -> void:
	var rows := int(plate.plate_radius_m / RIDGE_PITCH_M)
	var ridges := _ridges.multimesh
	ridges.instance_count = 2 * rows - 1
	for i in ridges.instance_count:
		var z := (i - rows + 1) * RIDGE_PITCH_M
		var length := 2 * sqrt(plate.plate_radius_m ** 2 - z ** 2)
		ridges.set_instance_transform(i, Transform3D(Basis.from_scale(Vector3(length, 1, 1)), Vector3(0, 0, z)))

## A real or virtual target of a plate, at the position of this node. Set its plate and role, then call [method place].
class_name HapticTarget
extends Marker3D

enum Role { REAL, VIRTUAL }

## The plate to which this target is added.
@export var plate: HapticRetargeting
## REAL: the hand is steered to the target. VIRTUAL: the user reaches for the target.
@export var role := Role.REAL

var _id := 0


## Adds the target to the plate, with the name of this node, or moves it to the current position of this node. Returns
## the id for HapticRetargeting.begin(), retarget() and get_gap(); 0 after an error.
func place() -> int:
	if plate == null:
		push_error("%s: plate is not set; choose the HapticRetargeting of this target" % name)
		return 0
	if _id != 0:
		return _id if plate.move_target_to(_id, global_position) == OK else 0
	var add := plate.add_real_target_at if role == Role.REAL else plate.add_virtual_target_at
	_id = add.call(name, global_position)
	return _id


func _exit_tree() -> void:
	if _id != 0 and is_instance_valid(plate):
		plate.remove_target(_id)
	_id = 0

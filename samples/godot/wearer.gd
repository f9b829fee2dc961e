## The view of the user: in a headset if OpenXR finds one, otherwise in an inset of the experimenter's view.
class_name Wearer
extends SubViewport

## Emitted when the headset has moved the origin of its space: the pose of the plate is then wrong.
signal recentred
signal taken_off

@onready var origin: XROrigin3D = $Origin
@onready var _board: Label3D = $Origin/Board
var _instruction := ""
var _problem := ""


## Starts the view. Returns true if a headset shows the view.
func start() -> bool:
	var xr := XRServer.find_interface("OpenXR") as OpenXRInterface
	if xr == null or not xr.is_initialized():
		return false
	use_xr = true
	DisplayServer.window_set_vsync_mode(DisplayServer.VSYNC_DISABLED)  # frames wait for the headset instead
	xr.pose_recentered.connect(recentred.emit)
	xr.instance_exiting.connect(taken_off.emit)
	return true


func show_instruction(instruction: String) -> void:
	if instruction != _instruction:
		print(instruction)
	_instruction = instruction
	_show()


## Shows a problem until this function is called with an empty text.
func warn(problem: String) -> void:
	if problem and problem != _problem:
		push_warning(problem)
	_problem = problem
	_show()


func _show() -> void:
	_board.text = _problem + "\n" + _instruction
	_board.modulate = Color(1, 0.85, 0.4) if _problem else Color.WHITE

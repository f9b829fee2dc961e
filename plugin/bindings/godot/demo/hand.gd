# Leads a hand that OpenXR tracks: the node Plate takes the tip of the index finger, once a frame, and its commands go to the
# plate's servo. For Godot 4.3 and later, whose XRHandTracker this is. Not run: no engine was at hand.
extends Node

@export var hand: StringName = &"/user/hand_tracker/right"
@onready var plate: HapticRetargeting = $Plate
## The origin of tracking, whose children are the tracked things.
@onready var origin: XROrigin3D = $XROrigin3D

func _ready() -> void:
	var xr := XRServer.find_interface("OpenXR")
	if xr == null or not xr.is_initialized():
		push_error("OpenXR is not there: enable it in the project's settings")
		return
	get_viewport().use_xr = true
	plate.plate_commanded.connect(func(orientation_deg: float) -> void: print("plate: %.1f degrees" % orientation_deg))
	var cylinder: int = plate.add_real_target(&"cylinder", -5.0, 0.1)
	var cup: int = plate.add_virtual_target(&"cup", 5.0, 0.1)
	plate.begin(cylinder, cup)

func _process(_delta: float) -> void:
	if not plate.is_reaching():
		return
	var time_ns := Time.get_ticks_usec() * 1000
	var tracker := XRServer.get_tracker(hand) as XRHandTracker
	var seen := tracker != null and tracker.has_tracking_data and \
			tracker.get_hand_joint_flags(XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP) & \
			XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED
	if seen:
		var tip := tracker.get_hand_joint_transform(XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP)
		plate.update_joint(origin.global_transform * tip, time_ns)
	else:
		plate.update_lost(time_ns)

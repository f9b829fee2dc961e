## The tip of the index finger of a hand that OpenXR tracks; draws the hand. Must be a child of the XROrigin3D.
class_name HandFinger
extends Finger

@export_enum("/user/hand_tracker/left", "/user/hand_tracker/right") var hand := "/user/hand_tracker/right"

@onready var _joints: MultiMesh = $Joints.multimesh
@onready var _bones: MultiMesh = $Bones.multimesh


func _ready() -> void:
	seen = false
	_joints.instance_count = XRHandTracker.HAND_JOINT_MAX
	_bones.instance_count = XRHandTracker.HAND_JOINT_MAX


func advance(_time_ns: int) -> void:
	var tracker := XRServer.get_tracker(hand) as XRHandTracker
	seen = tracker != null and tracker.has_tracking_data and 0 != (
			tracker.get_hand_joint_flags(XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP) &
			XRHandTracker.HAND_JOINT_FLAG_POSITION_TRACKED)
	visible = seen
	if seen:
		transform = tracker.get_hand_joint_transform(XRHandTracker.HAND_JOINT_INDEX_FINGER_TIP)
		for joint in XRHandTracker.HAND_JOINT_MAX:
			_draw(tracker, joint)


func problem() -> String:
	var xr := XRServer.find_interface("OpenXR") as OpenXRInterface
	if not seen and (xr == null or not xr.is_hand_tracking_supported()):
		return "This headset tracks no hands. Turn hand tracking on, or start with --person or --mouse."
	return super()


func _draw(tracker: XRHandTracker, joint: int) -> void:
	var radius := maxf(tracker.get_hand_joint_radius(joint), 0.005)
	var at := transform.affine_inverse() * tracker.get_hand_joint_transform(joint).origin
	_joints.set_instance_transform(joint, Transform3D(Basis.from_scale(Vector3.ONE * 2 * radius), at))
	var bone := transform.affine_inverse() * tracker.get_hand_joint_transform(_parent(joint)).origin - at
	var along := Basis(Quaternion(Vector3.UP, bone.normalized())) if bone else Basis()
	_bones.set_instance_transform(joint, Transform3D(along.scaled_local(Vector3(2 * radius, bone.length(), 2 * radius)), at + bone / 2))


## Returns the joint at the other end of the bone of a joint. The first bone of each finger begins at the wrist.
func _parent(joint: int) -> int:
	const FIRST: Array[int] = [XRHandTracker.HAND_JOINT_PALM, XRHandTracker.HAND_JOINT_WRIST, XRHandTracker.HAND_JOINT_THUMB_METACARPAL,
			XRHandTracker.HAND_JOINT_INDEX_FINGER_METACARPAL, XRHandTracker.HAND_JOINT_MIDDLE_FINGER_METACARPAL,
			XRHandTracker.HAND_JOINT_RING_FINGER_METACARPAL, XRHandTracker.HAND_JOINT_PINKY_FINGER_METACARPAL]
	return XRHandTracker.HAND_JOINT_WRIST if joint in FIRST else joint - 1

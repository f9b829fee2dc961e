# Runs the sample on Monado: a simulated person follows the session's instructions. The position of their finger is sent
# to Monado's remote driver, whose hand the session tracks through OpenXR.
extends Node

const PORT := 4242
const MAGIC := "mndrmt3"

@onready var session: Node = $Main
@onready var remote := StreamPeerTCP.new()
var person: SimulatedFinger
# Offset from the sent pose to the tip of the index finger, in the hand's axes: measured in frame 10, when the hand is
# at the origin.
var offset: Variant = null
var frames := 0

func _enter_tree() -> void:
	var xr: OpenXRInterface = XRServer.find_interface("OpenXR")
	xr.render_target_size_multiplier = 0.1  # rendering is in software

func _ready() -> void:
	get_viewport().disable_3d = true
	remote.connect_to_host("127.0.0.1", PORT)
	if not session.finger is HandFinger:
		push_error("no hand of OpenXR")
		return get_tree().quit(1)
	person = SimulatedFinger.new($Main/Desk/Plate, 1)
	person.visible = false
	add_child(person)
	session.finger.asked_for_step.connect(person.follow_step)
	session.finger.asked_to_touch.connect(func(place: Vector3) -> void: person.asked_to_touch.emit(place))
	session.finger.asked_to_slide.connect(person.slide)

func _process(_delta: float) -> void:
	remote.poll()
	if remote.get_status() != StreamPeerTCP.STATUS_CONNECTED:
		return
	frames += 1
	if frames == 10:
		offset = session.finger.position
	person.advance(session.time_ns)
	var wanted: Transform3D = session.finger.get_parent().global_transform.affine_inverse() * person.global_transform
	if offset == null:
		remote.put_data(packet(Transform3D()))
	else:
		remote.put_data(packet(wanted.translated_local(-offset)))

# Returns a packet for the driver: a head, an inactive left hand, and a right hand.
func packet(right: Transform3D) -> PackedByteArray:
	var data := StreamPeerBuffer.new()
	data.put_data(MAGIC.to_ascii_buffer())
	data.put_u8(0)
	data.put_data(zeros(96))  # fields of view and poses of views, marked as invalid
	put_pose(data, Transform3D(Basis(), Vector3(0, 1.6, 0)))
	data.put_u32(0)
	put_hand(data, Transform3D(), 0)
	put_hand(data, right, 1)
	return data.data_array

func put_pose(data: StreamPeerBuffer, at: Transform3D) -> void:
	var turn := at.basis.get_rotation_quaternion()
	for number: float in [turn.x, turn.y, turn.z, turn.w, at.origin.x, at.origin.y, at.origin.z]:
		data.put_float(number)

func put_hand(data: StreamPeerBuffer, at: Transform3D, active: int) -> void:
	put_pose(data, at)
	data.put_data(zeros(24 + 20 + 32))  # velocities, curls of the fingers, triggers
	data.put_u8(active)
	data.put_u8(active)
	data.put_data(zeros(14))  # buttons

func zeros(count: int) -> PackedByteArray:
	var bytes := PackedByteArray()
	bytes.resize(count)
	return bytes

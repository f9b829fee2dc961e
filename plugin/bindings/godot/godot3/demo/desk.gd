# A desk with a ridged plate on it. A simulated user slides a finger towards a cup that only they feel, on the left;
# the plate turns, and the finger arrives at the cylinder, on the right. SIMULATION: nobody is measured here.
#
# With --picture=FILE it saves what is drawn when the finger has arrived, and prints where things are in it.
extends Node

const REACH_SECONDS = 3.0
const REACH_M = 0.1
const START = Vector3(0, 0, 0.05)
const REAL_DEG = -5.0
const VIRTUAL_DEG = 5.0

onready var plate = $Plate
onready var drawing = $Plate/Drawing

var user = preload("res://user.gd").new(VIRTUAL_DEG)
var finger = START
var time_s = 0.0
var commanded_deg = 0.0
var arrived = false

func _ready():
	var real = plate.add_real_target("cylinder", REAL_DEG, REACH_M)
	var felt = plate.add_virtual_target("cup", VIRTUAL_DEG, REACH_M)
	var authority = plate.get_authority(real, felt)
	print("a gap of %.1f deg; %.1f deg can be held" % [authority.gap_deg, authority.max_gap_deg])
	drawing.place_targets(START + along(REAL_DEG) * REACH_M, START + along(VIRTUAL_DEG) * REACH_M)
	if plate.begin(real, felt) != OK:
		get_tree().quit(1)

func _process(delta):
	if arrived:
		return
	time_s += delta
	user.feel_until(time_s, commanded_deg)
	finger += along(user.direction_deg) * REACH_M / REACH_SECONDS * delta
	drawing.show_finger(finger)
	if plate.update(plate.global_transform.xform(finger), int(time_s * 1e9)) != OK:
		get_tree().quit(1)
	if time_s >= REACH_SECONDS:
		arrived = true
		plate.end()

func _on_plate_commanded(orientation_deg):
	commanded_deg = orientation_deg

func _on_reach_ended(_final_miss_deg):
	var miss_mm = finger.distance_to(START + along(REAL_DEG) * REACH_M) * 1000
	print("arrived %.1f mm from the cylinder; the user felt %+.1f deg, the cup being at %+.1f deg (simulated)" % [
			miss_mm, user.felt_deg, VIRTUAL_DEG])
	yield(save_picture(), "completed")
	get_tree().quit(0 if miss_mm < 2 else 1)

# In the plate's coordinates: from the mid-line, -z, counter-clockwise seen from above.
func along(direction_deg):
	return Vector3(0, 0, -1).rotated(Vector3.UP, deg2rad(direction_deg))

func save_picture():
	yield(get_tree(), "idle_frame")
	yield(get_tree(), "idle_frame")
	for argument in OS.get_cmdline_args():
		if argument.begins_with("--picture="):
			drawing.save_picture(argument.trim_prefix("--picture="))

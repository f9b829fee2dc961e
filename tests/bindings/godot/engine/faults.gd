# Runs the sample with its simulated person through faults: the hand is lost in a reach, the view is recentred in a
# reach and in a set-up, the plate fails and is opened again, the window is closed. Then prints the lines of the board
# and the number of results.
extends Node

@onready var session: Node = $Main
@onready var plate: HapticRetargeting = $Main/Desk/Plate
@onready var board: Label3D = $Main/Wearer/Origin/Board
var frames_lost := 0
var lines: PackedStringArray = []
var held_deg := NAN
var reaches_begun := 0
var was_reaching := false
var recentred_set_up := false

func _process(_delta: float) -> void:
	var line := board.text.get_slice("\n", 0)
	if line and line not in lines:
		lines.append(line)
	if plate.is_setting_up() and session.time_ns > 20e9 and not recentred_set_up:
		recentred_set_up = true
		recentre()
	if plate.is_reaching() and not was_reaching:
		reaches_begun += 1
	was_reaching = plate.is_reaching()
	var command := plate.get_command()
	if not was_reaching or not command or command.distance_to_go_m > 0.06:
		return
	match reaches_begun:
		1:
			lose_hand(command)
		2:
			recentre()
		4:
			session.device = "serial:/nonexistent"  # unplugged
			plate.open_device(session.device)
			await get_tree().create_timer(1.0).timeout
			session.device = OS.get_environment("HRT_PLATE_DEVICE")  # plugged in again: the session opens it
		5:
			session.notification(NOTIFICATION_WM_CLOSE_REQUEST)
			report()

func recentre() -> void:
	$Main/Wearer.recentred.emit()
	if not plate.is_setting_up():
		push_error("the plate is not placed again")

func lose_hand(command: Dictionary) -> void:
	frames_lost += 1
	session.finger.seen = frames_lost > 15
	if frames_lost == 2:
		held_deg = command.plate_orientation_deg
	if frames_lost == 15 and command.plate_orientation_deg != held_deg:
		push_error("the plate is not held: %s, then %s" % [held_deg, command.plate_orientation_deg])

func report() -> void:
	set_process(false)
	var rows := FileAccess.get_file_as_string("user://results.csv").strip_edges().get_slice_count("\n") - 1
	print("%d reaches begun, %d kept; %s" % [reaches_begun, rows, " | ".join(lines)])

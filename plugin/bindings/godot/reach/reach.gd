# The reach that every host's sample runs, in Godot: gives the node Plate one recorded sample a frame, and prints
# the hash of the commands that come out, which is the same on every host.
#
# The finger's positions are passed as three numbers, since a Vector3 holds floats and the recording doubles.
extends Node

@onready var plate: HapticRetargeting = $Plate

var recording: FileAccess
var columns := {}
var fnv := (0xcbf29ce4 << 32) | 0x84222325
var updates := 0

func _ready() -> void:
	recording = FileAccess.open("res://reach/reach.csv", FileAccess.READ)
	if recording == null:
		return stop("res://reach/reach.csv cannot be read")
	var header := next_row()
	for i in header.size():
		columns[header[i]] = i
	var real: int = plate.add_real_target("cylinder", -5.0, 0.1)
	var felt: int = plate.add_virtual_target("cup", 5.0, 0.1)
	if plate.begin(real, felt) != OK:
		stop("the reach does not begin")

func _process(_delta: float) -> void:
	var row := next_row()
	while row.size() > 1 and row[columns["call"]] != "update":
		row = next_row()
	if row.size() <= 1:
		return finish()
	var error: int = plate.update_sample(int(row[columns["sample_flags"]]), int(row[columns["time_ns"]]), 0.0,
			number(row, "sample_x_m"), number(row, "sample_y_m"), number(row, "sample_z_m"),
			number(row, "measured_plate_deg"))
	if error != OK:
		return stop("update %d is refused" % updates)
	hash_command(plate.get_command())
	updates += 1

func finish() -> void:
	if plate.end() != OK:
		return stop("the reach does not end")
	var summary: Dictionary = plate.get_summary()
	print("hash 0x%08x%08x" % [(fnv >> 32) & 0xffffffff, fnv & 0xffffffff])
	print("updates %d, steps %d, of these predicted %d" % [updates, summary.steps + summary.predicted_steps,
			summary.predicted_steps])
	print("ended %.1f mm from the real target, %.2f deg beside it (simulated)" % [
			summary.distance_to_target_m * 1000, abs(summary.miss_deg)])
	set_process(false)
	get_tree().quit(0)

func stop(why: String) -> void:
	push_error(why)
	set_process(false)
	get_tree().quit(1)

# The next line that is not a comment, cut into cells; of one cell at the end of the file.
func next_row() -> PackedStringArray:
	var line := recording.get_line()
	while line.begins_with("#"):
		line = recording.get_line()
	return line.split(",")

# 0 of an empty cell.
func number(row: PackedStringArray, column: String) -> float:
	return float(row[columns[column]])

# FNV-1a of HRT_HASHED_FIELDS (study.h).
func hash_command(command: Dictionary) -> void:
	var bytes := StreamPeerBuffer.new()
	bytes.put_64(command.flags)
	bytes.put_64(command.step)
	for field in ["plate_orientation_deg", "finger_direction_deg", "perceived_direction_deg",
			"aimed_direction_deg", "distance_to_go_m", "tactile_weight", "tactile_weight_sd",
			"time_to_go_s", "felt_error_deg", "predicted_miss_deg", "misfit", "miss_sd_deg"]:
		bytes.put_double(command[field])
	for byte in bytes.data_array:
		fnv = (fnv ^ byte) * 0x100000001b3

## Results of a session as CSV. The row of a reach is written as soon as the reach has ended.
class_name Results
extends RefCounted

const COLUMNS: PackedStringArray = ["miss_deg", "miss_sd_deg", "distance_to_target_m", "peak_felt_error_deg", "bearing_deg",
		"tactile_weight", "duration_s", "samples", "dropped_samples", "flags"]
const ON_TARGET_DEG := 1.5

var count := 0
var _file: FileAccess
var _on_target := 0


## Opens the file. Returns an error, or an empty text.
func open(path: String) -> String:
	_file = FileAccess.open(path, FileAccess.WRITE)
	if _file == null:
		return "%s cannot be written: %s. Choose another folder with --out." % [path, error_string(FileAccess.get_open_error())]
	_file.store_csv_line(PackedStringArray(["reach", "virtual", "gap_deg"]) + COLUMNS)
	return ""


func add(virtual_target: String, gap: Dictionary, summary: Dictionary) -> void:
	count += 1
	_on_target += 1 if absf(summary.miss_deg) < ON_TARGET_DEG else 0
	var row: PackedStringArray = [str(count), virtual_target, str(gap.gap_deg)]
	for column in COLUMNS:
		row.append(str(summary[column]))
	_file.store_csv_line(row)
	_file.flush()


func text() -> String:
	return "%d of %d reaches ended within %.1f° of the real target" % [_on_target, count, ON_TARGET_DEG]

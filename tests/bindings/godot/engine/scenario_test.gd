# Runs the scenario of all hosts (tests/bindings/scenario.txt) by the node's methods.
extends "res://tests/checks.gd"

var plate: HapticRetargeting
var targets := {}
var profile := ""

func test_scenario() -> void:
	plate = new_plate()
	var played := 0
	for line in FileAccess.get_file_as_string(OS.get_environment("HRT_SCENARIO")).split("\n", false):
		if line.begins_with("#"):
			continue
		played += 1
		var refusal := line.split(" ! ")
		var gives := refusal[0].split(" -> ")
		var words := gives[0].split(" ", true, 1)
		var made := make.bind(words[0], pairs(words[1] if words.size() > 1 else ""))
		if refusal.size() > 1:
			var word := refusal[1].split(" ", true, 1)[1]
			var nothing: Variant = refused(word.trim_prefix("HRT_") if not word.begins_with("hrt_") else ": ", made)
			check(nothing.is_empty() if nothing is Dictionary else nothing != OK, line)
			continue
		var gave: Variant = made.call()
		check(not gave.is_empty() if gave is Dictionary else gave == OK, line)
		var wanted := pairs(gives[1] if gives.size() > 1 else "")
		for key: String in wanted:
			if key == "flags":
				check(gave.flags & int(wanted.flags) != 0, line)
			else:
				check_near(float(gave[key]), float(wanted[key]), line)
	check(played > 30, "the scenario was played")

func make(name_of_call: String, a: Dictionary) -> Variant:
	match name_of_call:
		"configure":
			plate.tactile_weight = float(a.tactile_weight)
			return OK
		"target":
			var id: int = plate.call("add_%s_target" % a.role, a.name, number(a.direction_deg), number(a.distance_m))
			if id == 0:
				return FAILED
			targets[a.name] = id
			return OK
		"remove": return plate.remove_target(targets[a.name])
		"gap": return plate.get_gap(targets[a.real], targets[a.virtual])
		"begin", "retarget": return plate.call(name_of_call, targets[a.real], targets[a.virtual])
		"update": return plate.update(place(a.at), int(a.time_ns))
		"lost": return plate.get_command() if plate.update_lost(int(a.time_ns)) == OK else {}
		"slide": return slide(a)
		"set_up": return set_up(int(a.what), int(a.frames))
		"touched": return plate.touched(place(a.at), float(a.sd_m))
		"cancel": return plate.cancel()
		"end": return plate.get_summary() if plate.end() == OK else {}
		"save_profile":
			profile = plate.save_profile()
			return OK
		"load_profile": return plate.load_profile(a.get("text", profile))
	check(false, "a call of the scenario: " + name_of_call)
	return FAILED

func slide(a: Dictionary) -> Dictionary:
	var from := place(a.get("from", "0,0,0.05"))
	var copies := int(a.get("copies", "1"))
	for i in int(a.frames):
		if "real" in a and plate.retarget(targets[a.real], targets[a.virtual]) != OK:
			return {}
		var at := from.lerp(place(a.to), (i - i % copies) / (int(a.frames) - 1.0))
		if plate.update(at, int(a.get("begin_ns", "0")) + i * int(a.get("every_ns", "11111111"))) != OK:
			return {}
	return plate.get_command()

func set_up(what: int, frames: int) -> Dictionary:
	var results: Array[Dictionary] = []
	var take := func(result: Dictionary) -> void: results.append(result)
	plate.setup_finished.connect(take, CONNECT_ONE_SHOT)
	if plate.begin_setup(what) != OK or plate.begin_simulated_finger(0, 1) != OK:
		return {}
	for i in frames:
		if plate.is_setting_up() and not plate.update_simulated_finger(i * 11111111).is_finite():
			return {}
	return results[0] if results else {}

func pairs(words: String) -> Dictionary:
	var found := {}
	for word in words.split(" ", false):
		var pair := word.split("=", true, 1)
		found[pair[0]] = pair[1]
	return found

func number(text: String) -> float:
	return NAN if text == "nan" else float(text)

func place(text: String) -> Vector3:
	var parts := text.split(",")
	return Vector3(number(parts[0]), number(parts[1]), number(parts[2]))

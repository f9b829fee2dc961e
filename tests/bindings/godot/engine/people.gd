# Ten simulated people make ten reaches each, bit-identical to those of tests/bindings/godot/people.py. Also measures the cost of a frame.
extends SceneTree

const FRAME_NS := 11111111

var numbers: PackedFloat64Array = []
var on_target := 0

func _initialize() -> void:
	process_frame.connect(run, CONNECT_ONE_SHOT)  # the root is then in the tree

func run() -> void:
	for person in 10:
		var plate := new_plate()
		for reach in 10:
			lead(plate, person)
		plate.free()
	var hash := HashingContext.new()
	hash.start(HashingContext.HASH_SHA256)
	hash.update(numbers.to_byte_array())
	print("%d of 100 reaches within 1.5 degrees, %s" % [on_target, hash.finish().hex_encode()])
	measure()
	quit()

func new_plate() -> HapticRetargeting:
	var plate := HapticRetargeting.new()
	root.add_child(plate)
	plate.add_real_target("cylinder", -5.0, 0.1)
	plate.add_virtual_target("cup", 5.0, 0.1)
	return plate

func lead(plate: HapticRetargeting, person: int) -> void:
	plate.begin(plate.find_target("cylinder"), plate.find_target("cup"))
	plate.begin_simulated_finger(plate.find_target("cup"), person)
	for frame in 900:
		plate.update_simulated_finger(frame * FRAME_NS)
		var command := plate.get_command()
		numbers.append(command.plate_orientation_deg)
		if command.flags & HapticRetargeting.COMMAND_ARRIVED:
			break
	plate.end()
	numbers.append(plate.get_summary().miss_deg)
	on_target += 1 if absf(plate.get_summary().miss_deg) < 1.5 else 0

# Measures the time of update(), with the engine's call, and the growth of the engine's memory.
func measure() -> void:
	var plate := new_plate()
	plate.begin_simulated_finger(plate.find_target("cup"), 1)
	var way: PackedVector3Array = []
	for frame in 200:
		way.append(plate.move_simulated_finger(frame * FRAME_NS))
	var used_us: PackedInt64Array = []
	used_us.resize(51)
	var before := OS.get_static_memory_usage()
	for repeat in used_us.size():
		plate.begin(plate.find_target("cylinder"), plate.find_target("cup"))
		used_us[repeat] = Time.get_ticks_usec()
		for frame in way.size():
			plate.update(way[frame], frame * FRAME_NS)
		used_us[repeat] = Time.get_ticks_usec() - used_us[repeat]
		plate.cancel()
	var grown := OS.get_static_memory_usage() - before
	used_us.sort()  # the median, because of other work on the machine
	print("update: %.1f microseconds a frame, %d bytes" % [used_us[25] / float(way.size()), grown])

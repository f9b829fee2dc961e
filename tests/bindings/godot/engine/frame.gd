# Measures the time of calls of update() by the engine, and the growth of its memory, on a simulated person's path.
extends SceneTree

func _initialize() -> void:
	process_frame.connect(run, CONNECT_ONE_SHOT)  # when the root is in the tree

func run() -> void:
	var plate := HapticRetargeting.new()
	root.add_child(plate)
	var cylinder := plate.add_real_target("cylinder", -5.0, 0.1)
	var cup := plate.add_virtual_target("cup", 5.0, 0.1)
	plate.begin_simulated_finger(cup, 1)
	var path: PackedVector3Array = []
	for frame in 200:
		path.append(plate.move_simulated_finger(frame * 11111111))
	var used_us: PackedInt64Array = []
	used_us.resize(51)
	var before := OS.get_static_memory_usage()
	for repeat in used_us.size():
		plate.begin(cylinder, cup)
		used_us[repeat] = Time.get_ticks_usec()
		for frame in path.size():
			plate.update(path[frame], frame * 11111111)
		used_us[repeat] = Time.get_ticks_usec() - used_us[repeat]
		plate.cancel()
	var grown := OS.get_static_memory_usage() - before
	used_us.sort()  # the median, because of other work on the machine
	print("update: %.1f microseconds a frame, %d bytes" % [used_us[25] / float(path.size()), grown])
	quit()

# Runs each function test_* of the scripts *_test.gd in this folder in a new object. Prints PASS and the number of
# checks, or FAIL. Needs Godot 4.5 or later, in which scripts can read errors.
extends SceneTree

const FOLDER := "res://tests/"

func _initialize() -> void:
	process_frame.connect(run, CONNECT_ONE_SHOT)  # when the root is in the tree

func run() -> void:
	var checks := 0
	var failed := 0
	for file in DirAccess.get_files_at(FOLDER):
		if not file.ends_with("_test.gd"):
			continue
		var script: GDScript = load(FOLDER + file)
		for method in script.get_script_method_list():
			if not method.name.begins_with("test_"):
				continue
			var test: Node = script.new()
			root.add_child(test)
			OS.add_logger(test.logger)
			test.call(method.name)
			OS.remove_logger(test.logger)
			test.finish("%s %s" % [file, method.name])
			checks += test.checks
			failed += 1 if test.failures else 0
			test.free()
	print("FAIL %d tests" % failed if failed else "PASS %d checks" % checks)
	quit(1 if failed else 0)

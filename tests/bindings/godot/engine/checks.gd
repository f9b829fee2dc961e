# Functions for tests of the class: checks, and expected errors of the engine.
extends Node

class Errors extends Logger:
	var texts: PackedStringArray = []
	var warnings: PackedStringArray = []

	func _log_error(_function: String, _file: String, _line: int, code: String, rationale: String, _notify: bool,
			type: int, _backtraces: Array[ScriptBacktrace]) -> void:
		(warnings if type == ERROR_TYPE_WARNING else texts).append(rationale if rationale else code)

var logger := Errors.new()
var checks := 0
var failures: PackedStringArray = []

func check(right: bool, what: String) -> void:
	checks += 1
	if not right:
		failures.append(what)

func check_equal(value: Variant, wanted: Variant, what: String) -> void:
	check(typeof(value) == typeof(wanted) and value == wanted, "%s is %s; wanted %s" % [what, value, wanted])

func check_near(value: float, wanted: float, what: String, within := 1e-4) -> void:
	check(absf(value - wanted) < within, "%s is %s; wanted %s" % [what, value, wanted])

# Returns the result of `call`, which must print one error that contains the text.
func refused(text: String, call: Callable) -> Variant:
	var before := logger.texts.size()
	var result: Variant = call.call()
	var errors := logger.texts.slice(before)
	check(errors.size() == 1 and errors[0].contains(text), "one error '%s' was expected; there were %s" % [text, errors])
	logger.texts = logger.texts.slice(0, before)
	return result

func finish(name_of_test: String) -> void:
	for text in logger.texts:
		failures.append("an error that was not expected: " + text)
	if checks == 0:
		failures.append("checks nothing")
	for failure in failures:
		print("%s: %s" % [name_of_test, failure])

func new_plate() -> HapticRetargeting:
	var plate := HapticRetargeting.new()
	add_child(plate)
	return plate

func reaching_plate() -> HapticRetargeting:
	var plate := new_plate()
	check_equal(plate.begin(plate.add_real_target("real", -5.0, 0.1), plate.add_virtual_target("felt", 5.0, 0.1)), OK,
			"begin")
	return plate

# The plate's device as a script meets it, with emulated plates: HRT_PLATE_DEVICE is the firmware on its board,
# HRT_PLATE_SERVO a Dynamixel. Prints PASS, or FAIL and what for. A line "error: TEXT" announces an error that the engine
# is to print.
extends Node

const HRT = preload("res://addons/haptic_retargeting/constants.gd")

onready var plate = $Plate
var failures = 0

func _ready():
	check_refusals()
	check_turns("HRT_PLATE_DEVICE", "protocol 2, firmware 1.0.0, serial number 000000")
	check_turns("HRT_PLATE_SERVO", "Dynamixel XL330-M288, id 1, firmware 52")
	check_reach()
	print("FAIL" if failures else "PASS device")
	get_tree().quit(1 if failures else 0)

func check_equal(value, wanted, what):
	if typeof(value) != typeof(wanted) or value != wanted:
		failures += 1
		print("FAIL: %s is %s; wanted %s" % [what, value, wanted])

func expect_error(text):
	print("error: ", text)

# The report as soon as `key` is `wanted`; a busy machine gets 30 s.
func eventually(key, wanted, orientation_deg = null):
	for _i in range(3000):
		if orientation_deg != null:
			plate.turn_device(orientation_deg)
		var report = plate.get_device_report()
		if report.get(key) == wanted:
			return report
		OS.delay_msec(10)
	check_equal(plate.get_device_report().get(key), wanted, key)
	return plate.get_device_report()

func check_refusals():
	check_equal(plate.get_device_report().empty(), true, "a report without a device")
	expect_error("hrt_plate_open: device is of kind \"usb\"")
	check_equal(plate.open_device("usb:0"), ERR_PARAMETER_RANGE_ERROR, "open of a wrong name")
	check_equal(plate.open_device("serial:/nonexistent"), OK, "open")
	var report = eventually("state", HRT.PLATE_STATE_FAILED)
	check_equal(report.fault, HRT.PLATE_FAULT_LINE, "fault")
	var why = "the plate at /nonexistent cannot be opened: No such file or directory"
	check_equal(plate.get_device_message(), why, "message")
	expect_error(why)
	for _i in range(3):
		check_equal(plate.turn_device(10), ERR_UNAVAILABLE, "a turn of a failed device")
	check_equal(plate.close_device(), OK, "close")
	check_equal(plate.close_device(), OK, "close again")

func check_turns(variable, description):
	check_equal(plate.open_device(OS.get_environment(variable)), OK, "open")
	var report = eventually("state", HRT.PLATE_STATE_READY)
	check_equal(plate.get_device_description(), description, "description")
	check_equal(report.fault, HRT.PLATE_FAULT_NONE, "fault")
	report = eventually("orientation_deg", -45.0, 135)  # which feels like -45
	check_equal(report.command_deg, -45.0, "command")
	check_equal(report.flags & HRT.PLATE_REPORT_COMMANDED, HRT.PLATE_REPORT_COMMANDED, "flags")
	check_equal(plate.stop_device(), OK, "stop")

# The commands of a reach go to the device that is open, and where it stands goes into the samples.
func check_reach():
	plate.connect("plate_commanded", plate, "turn_device")
	plate.begin(plate.add_real_target("cylinder", -5, 0.1), plate.add_virtual_target("cup", 5, 0.1))
	check_equal(plate.update(Vector3(0, 0, 0.05), 0), OK, "update")
	check_equal(plate.update(Vector3(0, 0, 0.04), 100000000), OK, "update")
	var commanded = plate.get_command().plate_orientation_deg
	for _i in range(3000):
		if feels_like(commanded):
			break
		plate.turn_device(commanded)
		OS.delay_msec(10)
	check_equal(feels_like(commanded), true, "the device's command")
	check_equal(plate.cancel(), OK, "cancel")

# Ridges repeat every 180 degrees: the device takes the nearest that feels the same.
func feels_like(orientation_deg):
	var off_deg = fposmod(plate.get_device_report().command_deg - orientation_deg + 90, 180) - 90
	return abs(off_deg) < 0.1

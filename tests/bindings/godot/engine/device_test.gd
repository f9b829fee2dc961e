# Tests the plate's device with emulated plates: HRT_PLATE_DEVICE is a board, HRT_PLATE_FILE a Dynamixel servo.
extends "res://tests/checks.gd"

# Waits up to 30 s until `key` of the report is `wanted`, and returns the report. While waiting, turns the device to the
# orientation, if it is given.
func eventually(plate: HapticRetargeting, key: String, wanted: Variant, orientation_deg := NAN) -> Dictionary:
	for i in 3000:
		if not is_nan(orientation_deg):
			plate.turn_device(orientation_deg)
		if plate.get_device_report().get(key) == wanted:
			break
		OS.delay_msec(10)
	check_equal(plate.get_device_report().get(key), wanted, key)
	return plate.get_device_report()

func test_refusals() -> void:
	var plate := new_plate()
	check(plate.get_device_report().is_empty(), "a report without a device")
	check_equal(refused("open_device: device is of kind \"usb\"", plate.open_device.bind("usb:0")), ERR_PARAMETER_RANGE_ERROR,
			"open of a wrong name")
	check_equal(plate.open_device("serial:/nonexistent"), OK, "open")
	check_equal(eventually(plate, "state", HapticRetargeting.PLATE_STATE_FAILED).fault, HapticRetargeting.PLATE_FAULT_LINE, "fault")
	var why := ("the plate at /nonexistent cannot be opened: No such file or directory. "
			+ "Check its name, cable and permissions")
	check_equal(plate.get_device_report().message, why, "message")
	check_equal(refused(why, plate.turn_device.bind(10.0)), ERR_UNAVAILABLE, "a turn of a failed device")
	check_equal(plate.turn_device(10.0), ERR_UNAVAILABLE, "a repeated error, which is logged once")
	check_equal(plate.close_device(), OK, "close")
	check_equal(plate.close_device(), OK, "close again")

func test_turns() -> void:
	var devices := {
		"HRT_PLATE_DEVICE": "protocol 2, firmware 1.1.0, serial number 000000",
		"HRT_PLATE_FILE": "Dynamixel XL330-M288, id 1, firmware 52",  # a commissioned servo; it remains open after the loop
	}
	var plate := new_plate()
	for device: String in devices:
		check_equal(plate.open_device(OS.get_environment(device)), OK, "open")
		eventually(plate, "state", HapticRetargeting.PLATE_STATE_READY)
		check_equal(plate.get_device_report().description, devices[device], "description")
		var report := eventually(plate, "orientation_deg", -45.0, 135)  # equivalent to -45
		check_equal(report.fault, HapticRetargeting.PLATE_FAULT_NONE, "fault")
		check_equal(report.command_deg, -45.0, "command")
		check(report.flags & HapticRetargeting.PLATE_REPORT_COMMANDED != 0, "flags")
		check_equal(plate.stop_device(), OK, "stop")
	check_equal(plate.take_device(), OK, "take")
	check_equal(plate.plate_max_speed_deg_s, 123.0, "speed of the file")

func test_reach() -> void:
	var plate := new_plate()
	check_equal(plate.open_device(OS.get_environment("HRT_PLATE_DEVICE")), OK, "open")
	eventually(plate, "state", HapticRetargeting.PLATE_STATE_READY)
	plate.plate_commanded.connect(plate.turn_device)
	plate.begin(plate.add_real_target("cylinder", -5.0, 0.1), plate.add_virtual_target("cup", 5.0, 0.1))
	check_equal(plate.update(Vector3(0, 0, 0.05), 0), OK, "update")
	check_equal(plate.update(Vector3(0, 0, 0.04), 100000000), OK, "update")
	var commanded_deg: float = plate.get_command().plate_orientation_deg
	for i in 3000:
		if absf(off_deg(plate, commanded_deg)) < 0.1:
			break
		plate.turn_device(commanded_deg)
		OS.delay_msec(10)
	check_near(off_deg(plate, commanded_deg), 0, "the device's command", 0.1)
	check_equal(plate.cancel(), OK, "cancel")

# Returns the device's command minus the nearest equivalent of `orientation_deg`; ridges repeat every 180 degrees.
func off_deg(plate: HapticRetargeting, orientation_deg: float) -> float:
	return fposmod(plate.get_device_report().command_deg - orientation_deg + 90, 180) - 90

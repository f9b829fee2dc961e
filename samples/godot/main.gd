## A session: after a guided set-up, the user reaches for virtual objects and arrives at a real one.
##
##     godot --path . -- --person       a simulated person instead of the user of a headset
##     godot --path . -- --mouse        a finger that follows the mouse
##     godot --path . -- --out=FOLDER   writes the results and pictures to FOLDER, and ends the program
##     godot --path . -- --reaches=20   sets a property of this node: a number, a text, or texts separated by commas
extends Node3D

signal ended

enum State { SETTING_UP, GOING_TO_START, REACHING, OVER }

## Largest distance of the tracked joint from the start while the finger touches the start.
const START_RADIUS_M := 0.03
## Largest motion of the tracked joint while the finger rests, due to tracker noise.
const MAX_REST_MOTION_M := 0.008
## Time after which a device that has failed is opened again.
const REOPENING_S := 3.0

## Name of the device that turns the plate, such as serial:/dev/ttyACM0; empty: the plate is only drawn.
@export var device := ""
## Parts of the set-up. Without parts, the plate has the pose of the scene's file. --mouse replaces all parts except
## Guides by Registration.
@export_flags("Fingertip:1", "Registration:2", "Guides:8", "Calibration:16", "All that is missing:64") var set_up := 64
@export_range(1, 100) var reaches := 6
@export var virtual_targets: PackedStringArray = ["bottle", "goblet", "pawn"]
## Time for which the finger must rest at the start before a reach.
@export_range(0.2, 3.0, 0.1, "suffix:s") var rest_s := 0.6
@export var seed_of_person := 1

var finger: Finger
var time_ns := 0
var _state := State.OVER
var _to_set_up: Array[int] = []
var _feasible := PackedStringArray()
var _gap := {}
var _rest_position := Vector3.INF
var _rested_s := 0.0
var _failed_s := 0.0
var _notice := ""
var _is_finished := false
var _folder := "user://"
var _results := Results.new()
@onready var _desk: Desk = $Desk
@onready var _plate: HapticRetargeting = $Desk/Plate
@onready var _wearer: Wearer = $Wearer
@onready var _experimenter: Experimenter = $Experimenter


func _ready() -> void:
	get_tree().auto_accept_quit = false
	for argument in OS.get_cmdline_user_args():
		var value := argument.get_slice("=", 1)
		var property := argument.trim_prefix("--").get_slice("=", 0)
		if property == "out":
			_folder = value
		elif property in self:
			set(property, value.split(",") if property == "virtual_targets" else type_convert(value, typeof(get(property))))
		elif "=" in argument:
			_wearer.warn("%s is not an option. README.md lists the options." % argument)
	var headset := _wearer.start()
	for problem: String in [_results.open(_folder.path_join("results.csv")), _desk.open()]:
		if problem:
			return _stop(problem)
	finger = _make_finger(headset)
	_wearer.recentred.connect(_register_again)
	_wearer.taken_off.connect(_finish)
	_plate.setup_step.connect(_on_setup_step)
	_plate.setup_finished.connect(_on_setup_finished)
	_experimenter.look_at_plate(_plate, _wearer)
	if device:
		_plate.open_device(device)
		_plate.plate_commanded.connect(_plate.turn_device)
	if set_up & HapticRetargeting.SETUP_GUIDES:  # after the other parts, because guides need a registered plate
		_to_set_up.append(HapticRetargeting.SETUP_GUIDES)
	_begin_set_up(HapticRetargeting.SETUP_REGISTRATION if finger is MouseFinger else set_up & ~HapticRetargeting.SETUP_GUIDES)


func _process(delta: float) -> void:
	if _state == State.OVER:
		return
	time_ns += roundi(delta * 1e9)
	finger.advance(time_ns)
	_experimenter.show_finger(finger.global_position)
	if not _device_is_ready(delta):
		return
	_wearer.warn(finger.problem() if finger.problem() else _notice)
	match _state:
		State.SETTING_UP:
			_send()
		State.GOING_TO_START:
			if _rest_at_start(delta) >= rest_s:
				_begin_reach()
		State.REACHING:
			_reach()


func _notification(what: int) -> void:
	if what == NOTIFICATION_WM_CLOSE_REQUEST:
		await _finish()
		get_tree().quit()


func _make_finger(headset: bool) -> Finger:
	var arguments := OS.get_cmdline_user_args()
	var made: Finger
	if headset and "--person" not in arguments and "--mouse" not in arguments:
		made = preload("res://hand_finger.tscn").instantiate()
		_wearer.origin.add_child(made)
		return made
	if not headset:
		print("No headset: OpenXR has not started.")
	made = (MouseFinger.new(_plate) as Finger) if "--mouse" in arguments else SimulatedFinger.new(_plate, seed_of_person)
	add_child(made)
	return made


func _send() -> void:
	if finger.seen:
		_plate.update_joint(finger.global_transform, time_ns)
	else:
		_plate.update_lost(time_ns)


func _begin_set_up(what: int) -> void:
	_to_set_up.push_front(what)
	finger.show_to_wearer(true)
	if what == 0:
		_on_setup_finished({})
	elif _plate.begin_setup(what) == OK:
		_state = State.SETTING_UP
	else:
		_stop("The set-up cannot begin. See the log for the reason.")


func _on_setup_step(step: Dictionary) -> void:
	if step.instruction == HapticRetargeting.STEP_FINISH:
		return
	_wearer.show_instruction(step.text)
	_desk.show_hint(step.place_m)
	finger.asked_for_step.emit(step)


func _on_setup_finished(_result: Dictionary) -> void:
	_to_set_up.pop_front()
	_notice = ""
	_experimenter.look_at_plate(_plate, _wearer)
	if _to_set_up:
		_begin_set_up(_to_set_up.pop_front())
	else:
		_choose_targets()
		_go_to_start()


## Assigns real targets. Omits virtual targets whose gap is not feasible for this user.
func _choose_targets() -> void:
	_plate.assign_targets(false)
	var feasible := PackedStringArray()
	var infeasible := PackedStringArray()
	for virtual_target in virtual_targets:
		var gap := _plate.get_assigned(_plate.find_target(virtual_target))
		(feasible if gap.get("reachable") else infeasible).append(virtual_target)
	if infeasible:
		_notice = "The plate cannot guide you to a real object for %s. These targets are omitted." % ", ".join(infeasible)
	_feasible = feasible


## The headset has moved the origin of its space: registers the plate again, then repeats the interrupted set-up or reach.
func _register_again() -> void:
	if _state == State.OVER:
		return
	_notice = "The view was recentred. The plate must be registered again."
	_cancel()
	_begin_set_up(HapticRetargeting.SETUP_REGISTRATION)


func _cancel() -> void:
	if _plate.is_setting_up():
		_plate.cancel_setup()
	if _plate.is_reaching():
		_plate.cancel()
	_state = State.OVER


func _go_to_start() -> void:
	if not _feasible:
		return _stop(_notice)
	if _results.count == reaches:
		_finish()
		return
	_state = State.GOING_TO_START
	finger.show_to_wearer(true)
	_rested_s = 0.0
	_wearer.show_instruction("Put your finger on the start.")
	_desk.show_hint(_plate.start_position_m)
	finger.asked_to_touch.emit(_plate.to_global(_plate.start_position_m))


func _target_name() -> String:
	return _feasible[_results.count % _feasible.size()]


func _begin_reach() -> void:
	var virtual_target := _plate.find_target(_target_name())
	_gap = _plate.get_assigned(virtual_target)
	if not _gap or _plate.begin(_gap.real_target, virtual_target) != OK:
		return _stop("The reach to \"%s\" cannot begin. See the log for the reason." % _target_name())
	_state = State.REACHING
	_rested_s = 0.0
	finger.show_to_wearer(false)
	_wearer.show_instruction("Slide to the %s, and stop there." % _target_name())
	_desk.show_hint(_plate.to_local(_desk.object(_target_name()).global_position))
	_experimenter.begin(finger.global_position)
	finger.asked_to_slide.emit(virtual_target)


func _reach() -> void:
	_send()
	var command := _plate.get_command()
	if not command:
		return
	if finger.seen:
		_experimenter.follow(finger.global_position, command.perceived_direction_deg)
	_experimenter.report("%s: plate %.1f°, perceived-direction error %.1f°, %.0f mm to go" % [_target_name(),
			command.plate_orientation_deg, command.felt_error_deg, command.distance_to_go_m * 1000])
	if command.flags & HapticRetargeting.COMMAND_ARRIVED and _plate.end() == OK:
		_results.add(_target_name(), _gap, _plate.get_summary())
		_go_to_start()


func _rest_at_start(delta: float) -> float:
	var start := _plate.to_global(_plate.start_position_m)
	_rested_s += delta
	var rests := finger.seen and finger.global_position.distance_to(_rest_position) <= MAX_REST_MOTION_M
	if not rests or _rest_position.distance_to(start) > START_RADIUS_M:
		_rest_position = finger.global_position
		_rested_s = 0.0
	return _rested_s


## Returns true if there is no device or the device is ready. Opens a failed device again periodically, and repeats the
## interrupted reach.
func _device_is_ready(delta: float) -> bool:
	if not device:
		return true
	var report := _plate.get_device_report()
	if report.state == HapticRetargeting.PLATE_STATE_READY:
		return true
	if report.state != HapticRetargeting.PLATE_STATE_FAILED:
		return false
	_wearer.warn("The plate has failed: %s. The program opens it again every 3 s." % report.message)
	if _state == State.REACHING:
		_cancel()
		_go_to_start()
	_failed_s += delta
	if _failed_s > REOPENING_S:
		_failed_s = 0.0
		_plate.open_device(device)
	return false


func _finish() -> void:
	if _is_finished:
		return
	_is_finished = true
	_cancel()
	_plate.close_device()
	var text := _results.text() + (" (simulated)." if finger is SimulatedFinger else ".")
	_wearer.show_instruction(text)
	_experimenter.report(text)
	ended.emit()
	if DisplayServer.get_name() != "headless":
		await _experimenter.save_picture(_folder.path_join("experimenter.png"))
		if not _wearer.use_xr:
			_wearer.get_texture().get_image().save_png(_folder.path_join("wearer.png"))
	if _folder != "user://":
		get_tree().quit()


func _stop(why: String) -> void:
	_state = State.OVER
	_wearer.warn(why)
	if _folder != "user://":
		get_tree().quit(1)

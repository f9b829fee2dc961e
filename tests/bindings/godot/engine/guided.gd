# The joint of the README's second example: touches the requested marks of a plate at the pose PLATE, until the registration has
# moved the node to this pose and the set-up continues.
extends Node3D

const PLATE := Vector3(0.3, 0.75, -0.4)
@onready var plate: HapticRetargeting = $"../Plate"
var step := {}
var since_ms := 0

func _ready() -> void:
	plate.setup_step.connect(func(new_step: Dictionary) -> void:
		if new_step.instruction == HapticRetargeting.STEP_TOUCH_MARK:
			since_ms = Time.get_ticks_msec()
		step = new_step)

func _process(_delta: float) -> void:
	if not step:
		return
	var is_lifted := Time.get_ticks_msec() - since_ms < 150
	rotation = SimulatedFinger.TURNS[step.number % 6 if step.part == HapticRetargeting.SETUP_FINGERTIP else 0]
	position = PLATE + step.place_m + (Vector3(0, 0.05, 0) if is_lifted else Vector3())
	if plate.position.distance_to(PLATE) < 0.002 and step.instruction != HapticRetargeting.STEP_FINISH:
		print("the plate is found; next: ", $"../Label".text)
		get_tree().quit(0)

# The reach that every host's sample runs, in Godot: passes one scripted sample a frame to the node Plate, and prints
# the hash of the resulting commands, which is the same on every host.
#
# The finger's positions are passed as three numbers, since a Vector3 would round them to 32 bits.
extends Node

@onready var plate: HapticRetargeting = $Plate

var fnv := (0xcbf29ce4 << 32) | 0x84222325
var random := 7
var i := 0

func _ready() -> void:
	var real: int = plate.add_real_target("cylinder", -5.0, 0.1)
	var felt: int = plate.add_virtual_target("cup", 5.0, 0.1)
	if plate.begin(real, felt) != OK:
		stop("the reach does not begin; the error before this one has the reason")

# Passes sample i. Coordinates are constants or quotients of integers: the same doubles on every host.
func _process(_delta: float) -> void:
	i += 1
	if i > 170:
		return finish()
	var moved := clampi(i - 10, 0, 120)
	@warning_ignore("integer_division")
	var distance_um := moved * moved * (180 - moved) * 25 / 216
	@warning_ignore("integer_division")
	var right_um := distance_um * 87 / 1000
	var lost := i % 40 == 7 or (i > 40 and i <= 52)
	var lifted := i > 65 and i <= 75
	var flags := HapticRetargeting.SAMPLE_PLATE_ORIENTATION
	flags |= 0 if lost else HapticRetargeting.SAMPLE_PLATE_POSITION
	flags |= HapticRetargeting.SAMPLE_LIFTED if lifted else 0
	var time_ns := 20000000 * i + 400 * noise()
	var x_m := (right_um + noise()) / 1e6
	var z_m := (50000 - distance_um + noise()) / 1e6
	if i > 105 and i <= 108:
		return  # frames that the host drops
	if plate.update_sample(flags, time_ns, 0.0, x_m, 0.03 if lifted else 0.002, z_m,
			plate.get_command().get("plate_orientation_deg", 0.0)) != OK:
		return stop("sample %d is refused; the error before this one has the reason" % i)
	hash_command(plate.get_command())

func noise() -> int:
	random = random * 16807 % 2147483647
	return random % 1001 - 500

func finish() -> void:
	if plate.end() != OK:
		return stop("the reach does not end; the error before this one has the reason")
	var summary: Dictionary = plate.get_summary()
	print("hash 0x%08x%08x" % [(fnv >> 32) & 0xffffffff, fnv & 0xffffffff])
	print("ended %.1f mm from the real target, %.2f deg off its bearing (scripted)" % [
			summary.distance_to_target_m * 1000, abs(summary.miss_deg)])
	set_process(false)
	get_tree().quit(0)

func stop(why: String) -> void:
	push_error(why)
	set_process(false)
	get_tree().quit(1)

# Continues FNV-1a over HRT_HASHED_FIELDS (recording.h), which are the fields of a command in their order.
func hash_command(command: Dictionary) -> void:
	var bytes := StreamPeerBuffer.new()
	for field: String in command:
		if command[field] is int:
			bytes.put_64(command[field])
		else:
			bytes.put_double(command[field])
	for byte in bytes.data_array:
		fnv = (fnv ^ byte) * 0x100000001b3

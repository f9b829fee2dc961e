# The user, as the paper models them, without noise: what they feel is a mixture of the ridges' direction and the
# finger's; they steer what they feel towards the target.
extends RefCounted

const STEP_SECONDS := 0.1
const TACTILE_WEIGHT := 0.15
const MOTOR_VARIANCE_DEG2 := 0.5
const SENSORY_VARIANCE_DEG2 := 0.1

var direction_deg := 0.0
var variance_deg2 := 0.0
var next_step_s := STEP_SECONDS

# Whether a step ended.
func feel_until(time_s: float, plate_deg: float) -> bool:
	if time_s < next_step_s:
		return false
	next_step_s += STEP_SECONDS
	var signal_deg := TACTILE_WEIGHT * plate_deg + (1 - TACTILE_WEIGHT) * direction_deg
	var prior_deg2 := variance_deg2 + MOTOR_VARIANCE_DEG2
	var gain := prior_deg2 / (prior_deg2 + SENSORY_VARIANCE_DEG2)
	variance_deg2 = (1 - gain) * prior_deg2
	direction_deg -= gain * signal_deg
	return true

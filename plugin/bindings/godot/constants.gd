# The numbers of properties and flags; see session.h and reach.h of the plugin.
#
#   const HRT = preload("res://addons/haptic_retargeting/constants.gd")
#   if flags & HRT.COMMAND_SATURATED: ...

const SAMPLE_DIRECTION = 1
const SAMPLE_PLATE_POSITION = 2
const SAMPLE_PLATE_ORIENTATION = 4
const SAMPLE_LIFTED = 8

const COMMAND_HELD = 1
const COMMAND_PREDICTED = 2
const COMMAND_SATURATED = 4
const COMMAND_RATE_LIMITED = 8
const COMMAND_UNREACHABLE = 16
const COMMAND_LIFTED = 32
const COMMAND_OFF_PLATE = 64
const COMMAND_MISFIT = 128
const COMMAND_OFF_TARGET = 256
const COMMAND_RESTING = 512
const COMMAND_APPROXIMATE = 1024
const COMMAND_FAULT = 2048

const SESSION_PLATE_WAITS = 1

const CONTROL_MPC = 0
const CONTROL_FIXED_PLATE = 1
const GUIDANCE_FIXED_DIRECTION = 0
const GUIDANCE_ARRIVAL = 1
const GUIDANCE_LINE_OF_SIGHT = 1
const ADAPTATION_OFF = 0
const ADAPTATION_REACH = 1
const ADAPTATION_CARRIED = 2

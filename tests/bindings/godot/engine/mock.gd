# Draws the sample's session only where the mock runtime keeps a picture, since the processor draws: around every EVERY-th frame.
extends Node

const EVERY := 500
const AROUND := 4

var frames := 0

func _ready() -> void:
	$Main.ended.connect(func() -> void: get_viewport().disable_3d = false)
	get_viewport().disable_3d = true

func _process(_delta: float) -> void:
	frames += 1
	var drawn := frames % EVERY < AROUND
	$Main/Wearer.render_target_update_mode = SubViewport.UPDATE_ALWAYS if drawn else SubViewport.UPDATE_DISABLED

# Plate, ridges, finger, targets and path, seen from above: a child of the plate's node, so in its coordinates.
extends Spatial

const PLATE_RADIUS_M = 0.075
const RIDGE_M = 0.001
const RIDGE_SPACING_M = 0.01
const PATH_POINT_M = 0.002

const PLATE_COLOUR = Color("d8d4c8")
const RIDGE_COLOUR = Color("6b6658")
const REAL_COLOUR = Color("2f6fd0")
const VIRTUAL_COLOUR = Color("e0a020")
const FINGER_COLOUR = Color("d03030")
const PATH_COLOUR = Color("208040")

var camera = Camera.new()
var ridges = Spatial.new()
var real
var felt
var finger
var path = []

func _ready():
	camera.projection = Camera.PROJECTION_ORTHOGONAL
	camera.size = 0.2
	camera.near = 0.01
	camera.translation.y = 0.5
	camera.rotation_degrees.x = -90
	add_child(camera)
	camera.make_current()
	add_child(disc(PLATE_RADIUS_M, -0.002, 0.002, PLATE_COLOUR))
	add_child(ridges)
	var offset = -PLATE_RADIUS_M + RIDGE_SPACING_M / 2
	while offset < PLATE_RADIUS_M:
		add_ridge(offset)
		offset += RIDGE_SPACING_M
	finger = disc(0.004, 0.005, 0.004, FINGER_COLOUR)
	add_child(finger)

# At 0 degrees ridges run from left to right; what is felt is motion across them.
func add_ridge(offset):
	var box = CubeMesh.new()
	box.size = Vector3(2 * sqrt(PLATE_RADIUS_M * PLATE_RADIUS_M - offset * offset), RIDGE_M, RIDGE_M)
	var ridge = mesh(box, RIDGE_COLOUR)
	ridge.translation.z = offset
	ridges.add_child(ridge)

func turn_ridges(orientation_deg):
	ridges.rotation_degrees.y = orientation_deg

func place_targets(real_position, virtual_position):
	real = disc(0.006, 0.002, 0.002, REAL_COLOUR)
	real.translation += real_position
	add_child(real)
	felt = disc(0.006, 0.002, 0.002, VIRTUAL_COLOUR)
	felt.translation += virtual_position
	add_child(felt)

func show_finger(position):
	finger.translation = position + Vector3(0, 0.005, 0)
	if path.empty() or position.distance_to(path.back()) >= PATH_POINT_M:
		path.append(position)
		var point = disc(0.0008, 0.001, 0.004, PATH_COLOUR)
		point.translation += position
		add_child(point)

func disc(radius, height, thickness, colour):
	var cylinder = CylinderMesh.new()
	cylinder.top_radius = radius
	cylinder.bottom_radius = radius
	cylinder.height = thickness
	var instance = mesh(cylinder, colour)
	instance.translation.y = height
	return instance

func mesh(shape, colour):
	var material = SpatialMaterial.new()
	material.flags_unshaded = true
	material.albedo_color = colour
	var instance = MeshInstance.new()
	instance.mesh = shape
	instance.material_override = material
	return instance

func save_picture(file):
	var picture = get_viewport().get_texture().get_data()
	picture.flip_y()
	if picture.save_png(file) != OK:
		return push_error("cannot write " + file)
	print_pixel("finger", finger.translation, FINGER_COLOUR)
	print_pixel("real target, beside the finger", real.translation + Vector3(0.005, 0, 0), REAL_COLOUR)
	print_pixel("virtual target", felt.translation, VIRTUAL_COLOUR)
	print_pixel("path", path[path.size() / 4], PATH_COLOUR)
	for ridge in [ridges.get_child(3), ridges.get_child(9)]:
		print_pixel("ridge", ridges.transform.xform(ridge.translation + Vector3(0.04, 0, 0)), RIDGE_COLOUR)
		print_pixel("plate between ridges", ridges.transform.xform(ridge.translation +
				Vector3(0.04, 0, RIDGE_SPACING_M / 2)), PLATE_COLOUR)

# `position` in the plate's coordinates.
func print_pixel(name, position, colour):
	var pixel = camera.unproject_position(to_global(position))
	print("pixel %d %d is %s: %s" % [pixel.x, pixel.y, colour.to_html(false), name])

## Draws plates in the editor's view: rim, ridges at orientation 0, start, and the line straight ahead of it.
@tool
extends EditorPlugin

var _gizmos := PlateGizmos.new()


func _enter_tree() -> void:
	add_node_3d_gizmo_plugin(_gizmos)


func _exit_tree() -> void:
	remove_node_3d_gizmo_plugin(_gizmos)


class PlateGizmos extends EditorNode3DGizmoPlugin:
	const RIDGES := 12
	const SEGMENTS := 48

	func _init() -> void:
		create_material("plate", Color(0.99, 0.5, 0.5))

	func _get_gizmo_name() -> String:
		return "HapticRetargeting"

	func _has_gizmo(node: Node3D) -> bool:
		return node is HapticRetargeting

	func _redraw(gizmo: EditorNode3DGizmo) -> void:
		var plate: HapticRetargeting = gizmo.get_node_3d()
		var radius := plate.plate_radius_m
		var lines: PackedVector3Array = []
		for i in SEGMENTS:
			for end: int in [i, i + 1]:
				lines.append(Vector3.FORWARD.rotated(Vector3.UP, TAU * end / SEGMENTS) * radius)
		for i in RIDGES:
			var z := radius * (2.0 * (i + 0.5) / RIDGES - 1.0)
			var half := sqrt(radius ** 2 - z ** 2)
			lines.append_array([Vector3(-half, 0, z), Vector3(half, 0, z)])
		var start := plate.start_position_m
		lines.append_array([start, start + Vector3(0, radius / 2, 0), start, start + 2 * radius * Vector3.FORWARD])
		gizmo.clear()
		gizmo.add_lines(lines, get_material("plate", gizmo))

// Bridge that holds a real object over the plate. An object on the plate would turn with it.

// Position of the object in a direction from the start, at the length of a reach.
function object_at(direction_deg) =
    at_direction(reach_length_mm, direction_deg) - [0, start_distance_mm];

module head(hole_mm) {
  sockets_mm = [for (direction_deg = object_directions_deg) object_at(direction_deg)];
  difference() {
    for (column_deg = bridge_directions_deg) hull() {
      translate(at_direction(bridge_radius_mm, column_deg)) disc(bridge_column_mm, 2 * hole_facets);
      for (at_mm = sockets_mm) translate(at_mm) disc(12, 2 * hole_facets);
    }
    for (at_mm = sockets_mm) translate(at_mm) disc(hole_mm, hole_facets);
  }
}

module bridge() {
  pilot_z = 8;
  socket_z = head_bottom_z + socket_depth_mm;
  layer(0.2 - tenon_depth_mm, 0) difference() { tenons(tenon_mm); tenons(m3_pilot_mm); }
  layer(0, pilot_z) difference() { tenons(bridge_column_mm); tenons(m3_pilot_mm); }
  layer(pilot_z, head_bottom_z) tenons(bridge_column_mm);
  layer(head_bottom_z, socket_z) head(socket_mm + slide_fit_mm);
  layer(socket_z, head_top_z) head(m3_free_mm);
}

// Cylinder for one socket, at direction 0.
module object() {
  peg_z = head_bottom_z + socket_depth_mm - 0.2;
  pilot_z = peg_z - object_pilot_mm;
  translate(object_at(0)) {
    layer(object_bottom_z, pilot_z) disc(object_diameter_mm, 2 * hole_facets);
    layer(pilot_z, head_bottom_z) difference() { disc(object_diameter_mm, 2 * hole_facets); disc(m3_pilot_mm, hole_facets); }
    layer(head_bottom_z, peg_z) difference() { disc(socket_mm, 2 * hole_facets); disc(m3_pilot_mm, hole_facets); }
  }
}

// Bearing, servo and horn as bought, for pictures and for checks of clearance. Not printed.

module bearing() layer(bearing_bottom_z, floor_z) difference() { disc(bearing_outer_mm); disc(bearing_bore_mm); }

module servo() {
  top_z = flange_top_z + servo_above_flange_mm;
  translate([0, -servo_shaft_offset_mm]) {
    layer(servo_bottom_z, mount_top_z) square([servo_width_mm, servo_length_mm], center = true);
    layer(mount_top_z, flange_top_z) difference() {
      square([servo_width_mm, servo_flange_length_mm], center = true);
      for (x_mm = [-0.5, 0.5] * servo_hole_width_mm, y_mm = [-0.5, 0.5] * servo_hole_length_mm)
        translate([x_mm, y_mm]) disc(4.4, hole_facets);
    }
    layer(flange_top_z, top_z) square([servo_width_mm, servo_length_mm], center = true);
  }
  layer(top_z, horn_top_z - 2) disc(6, hole_facets);
}

module horn() {
  layer(horn_top_z - 2, horn_top_z) difference() {
    disc(horn_diameter_mm);
    rotate(180 / retainer_screws) holes(2.5, horn_hole_circle_mm, horn_holes);
  }
  layer(horn_top_z - 5, horn_top_z - 2) difference() { disc(9, 2 * hole_facets); disc(6.1, hole_facets); }
}

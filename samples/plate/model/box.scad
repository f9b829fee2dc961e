// Box without a floor for stop button, fuse holder and circuit board, next to the drum. The circuit board hangs under
// the lid on cable ties. Screws through the columns at its sides fix the box.

box_middle_mm = [deck_radius_mm + 30 + box_mm[0] / 2, 0];
box_top_z = drum_bottom_z + box_mm[2];

module box() {
  lid_z = box_top_z - 3;
  lug_z = drum_bottom_z + lug_height_mm;
  columns_mm = [for (side = [-1, 1]) [side * (box_mm[0] + lug_mm) / 2 - side * wall_mm, 0]];
  module outline(hole_mm) difference() {
    union() {
      square([box_mm[0], box_mm[1]], center = true);
      for (at_mm = columns_mm) translate(at_mm) disc(lug_mm, 2 * hole_facets);
    }
    for (at_mm = columns_mm) translate(at_mm) disc(hole_mm, hole_facets);
  }
  module walls(hole_mm) difference() {
    outline(hole_mm);
    square([box_mm[0] - 2 * wall_mm, box_mm[1] - 2 * wall_mm], center = true);
  }
  translate(box_middle_mm) {
    layer(lid_z, box_top_z) difference() {
      outline(9);
      translate([box_mm[0] / 2 - 24, -18]) disc(stop_hole_mm);
      translate([box_mm[0] / 2 - 24, 24]) disc(fuse_hole_mm);
      for (x_mm = [12, 60], y_mm = [-0.5, 0.5] * board_ties_mm)
        translate([x_mm - box_mm[0] / 2, y_mm]) square([6, 2.5], center = true);
    }
    layer(drum_bottom_z + cable_height_mm, lid_z) walls(9);
    layer(lug_z, drum_bottom_z + cable_height_mm) difference() { walls(9); cables(); }
    layer(drum_bottom_z, lug_z) difference() { walls(4.5); cables(); }
  }
  module cables() square([cable_width_mm, 2 * box_mm[1]], center = true);
}

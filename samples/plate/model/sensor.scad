// Arm for an AS5600 on the axis, under the magnet of a retainer with sensor_room_mm. The arm hangs under the deck and
// reaches between the retainer's columns, which can turn by 95 degrees in both directions.

sensor_posts_mm = [[-10, 40], [10, 40]];
sensor_arm_width_mm = 15;

// Columns of the retainer, on the user's side at orientation 0, next to the screw there.
module sensor_columns() for (direction_deg = [145, 215]) rotate(direction_deg) intersection() {
  difference() {
    disc(2 * land_radius_mm);
    disc(2 * land_radius_mm - 8);
  }
  polygon([[0, 0], at_direction(40, 20), at_direction(40, -20)]);
}

module sensor_arm() {
  bottom_z = sensor_arm_z - sensor_arm_mm;
  face_z = deck_bottom_z - 9;  // face for the head of a screw of 16 mm
  module posts_outline(hole_mm) for (at_mm = sensor_posts_mm) translate(at_mm) difference() {
    disc(12, 2 * hole_facets);
    disc(hole_mm, hole_facets);
  }
  module around_board(more_mm) intersection() {
    square(sensor_board_mm[0] + more_mm, center = true);
    disc(33.4);
  }
  layer(bottom_z, sensor_arm_z) difference() {
    union() {
      translate([-sensor_arm_width_mm / 2, 0]) square([sensor_arm_width_mm, 40]);
      around_board(3);
      hull() posts_outline(0.01);
    }
    for (at_mm = sensor_posts_mm) translate(at_mm) disc(post_washer_mm, hole_facets);
  }
  layer(sensor_arm_z, sensor_arm_z + 1) difference() {
    around_board(3);
    around_board(0);
    translate([-sensor_arm_width_mm / 2, 0]) square([sensor_arm_width_mm, 40]);  // opening for the wires
  }
  layer(sensor_arm_z, face_z) posts_outline(post_washer_mm);
  layer(face_z, deck_bottom_z) posts_outline(post_hole_mm);
}

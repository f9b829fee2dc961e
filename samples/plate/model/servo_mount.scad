// Mount that holds the servo under the deck, with its shaft on the plate's axis.

module posts(diameter_mm) {
  for (x_mm = [-post_x_mm, post_x_mm], y_mm = post_y_mm) translate([x_mm, y_mm]) disc(diameter_mm, 2 * hole_facets);
}

module mount_outline(hole_mm) {
  difference() {
    hull() posts(2 * post_radius_mm + 2);
    posts(hole_mm);
    translate([0, -servo_shaft_offset_mm]) {
      square([servo_width_mm + 0.6, servo_length_mm + 0.6], center = true);
      for (x_mm = [-0.5, 0.5] * servo_hole_width_mm, y_mm = [-0.5, 0.5] * servo_hole_length_mm)
        translate([x_mm, y_mm]) disc(m3_pilot_mm, hole_facets);
    }
  }
}

// Posts on a base. The base is the child, whose holes have the diameter $hole_mm.
module on_posts() {
  recess_z = mount_bottom_z + mount_recess_mm;
  layer(mount_bottom_z, recess_z) let($hole_mm = post_washer_mm) children();
  layer(recess_z, mount_top_z) let($hole_mm = post_hole_mm) children();
  layer(mount_top_z, deck_bottom_z) difference() {
    posts(2 * post_radius_mm);
    posts(post_hole_mm);
  }
}

module servo_mount() on_posts() mount_outline($hole_mm);

// Fixed ring around the plate, flush with its face, with the scale, the marks and the bearing's seat.

module ring() {
  difference() {
    deck_outline();
    disc(2 * deck_inner_radius_mm);
    translate([0, zero_pin_radius_mm]) disc(zero_pin_mm + slide_fit_mm, hole_facets);
  }
}

module tick(length_mm) translate([-0.4, 0]) square([0.8, length_mm]);

// Plate orientation: ticks every 15 degrees, positive to the left. The arrow is the mid-line.
module scale_of_orientation() {
  inner_mm = deck_inner_radius_mm + 1;
  around(inner_mm, [for (i = [-6:6]) if (i != 0) 15 * i]) tick(2.5);
  for (orientation_deg = [-90, -45, 45, 90])
    around(inner_mm + 3.4, [orientation_deg])
      lettering(str(orientation_deg > 0 ? "+" : "", orientation_deg));
  translate([0, inner_mm + 1]) union() {
    tick(12);
    translate([0, 13.5]) polygon([[0, 2], [-3, -3], [3, -3]]);
    translate([4, 2]) lettering("0");
  }
  around(inner_mm, [180]) tick(4);
  translate([13, -inner_mm - 6]) lettering("USER");
}

module tenons(diameter_mm) around(bridge_radius_mm, bridge_directions_deg) disc(diameter_mm, 2 * hole_facets);

module deck() {
  counterbore_z = -tenon_depth_mm - tenon_web_mm;
  assert(counterbore_z > floor_z);
  difference() {
    union() {
      layer(deck_bottom_z, bearing_bottom_z) deck_floor(bearing_outer_mm - 2 * bearing_land_mm, 0);
      layer(bearing_bottom_z, floor_z) deck_floor(bearing_outer_mm + bearing_fit_mm, zero_pin_mm + slide_fit_mm);
      layer(floor_z, counterbore_z) difference() { ring(); tenons(m3_head_mm); }
      layer(counterbore_z, -tenon_depth_mm) difference() { ring(); tenons(m3_free_mm); }
      layer(-tenon_depth_mm, -engraving_mm) difference() { ring(); tenons(tenon_mm + slide_fit_mm); }
      layer(-engraving_mm, 0) difference() {
        ring();
        tenons(tenon_mm + slide_fit_mm);
        scale_of_orientation();
      }
    }
    for (mark = deck_marks()) translate([mark[1][0], mark[1][1], 0]) dimple();
  }
}

module deck_floor(opening_mm, pin_mm) {
  difference() {
    deck_outline();
    disc(opening_mm);
    for (x_mm = [-post_x_mm, post_x_mm], y_mm = post_y_mm) translate([x_mm, y_mm]) disc(m3_pilot_mm, hole_facets);
    for (at_mm = sensor_posts_mm) translate(at_mm) disc(m3_pilot_mm, hole_facets);
    around(drum_screw_radius_mm, drum_directions_deg) disc(m3_pilot_mm, hole_facets);
    tenons(m3_head_mm);
    if (pin_mm > 0) translate([0, zero_pin_radius_mm]) disc(pin_mm, hole_facets);
  }
}

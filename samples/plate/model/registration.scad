// Parts for a registration: an object with a cup for the fingertip, and a strip that guides the fingertip there from
// the start's dimple. The strip lies over the ridges, held by object and deck, and is removed afterwards.

cup_front_y_mm = -object_diameter_mm / 2;  // the deepest point of the cup is the contact point of the plain object
cup_half_mm = cup_width_mm / 2 - cup_lip_mm;
cup_depth_mm = cup_radius_mm - sqrt(cup_radius_mm * cup_radius_mm - cup_half_mm * cup_half_mm);
strip_bottom_z = crest_z + 0.3;
strip_top_z = strip_bottom_z + strip_mm;

module object_cup() {
  module outline() difference() {
    translate([-cup_width_mm / 2, cup_front_y_mm - cup_depth_mm]) square([cup_width_mm, object_diameter_mm + cup_depth_mm]);
    translate([0, cup_front_y_mm - cup_radius_mm]) disc(2 * cup_radius_mm);
  }
  peg_z = head_bottom_z + socket_depth_mm - 0.2;
  translate(object_at(0)) {
    layer(object_bottom_z, peg_z - object_pilot_mm) outline();
    layer(peg_z - object_pilot_mm, head_bottom_z) difference() { outline(); disc(m3_pilot_mm, hole_facets); }
    layer(head_bottom_z, peg_z) difference() { disc(socket_mm, 2 * hole_facets); disc(m3_pilot_mm, hole_facets); }
  }
}

// Channel in coordinates of the start, with the object straight ahead. It narrows to the object's sides.
module channel(width_mm) {
  object_mm = cup_width_mm + slide_fit_mm + width_mm - strip_channel_mm;
  touched_mm = reach_length_mm + cup_front_y_mm;
  module bar(bar_mm, y_mm, length_mm = 0.01) translate([-bar_mm / 2, y_mm]) square([bar_mm, length_mm]);
  hull() { disc(width_mm); bar(width_mm, touched_mm - strip_lead_mm); }
  hull() { bar(width_mm, touched_mm - strip_lead_mm); bar(object_mm, touched_mm); }
  bar(object_mm, touched_mm, object_diameter_mm);
}

module strip() {
  start_mm = [0, -start_distance_mm];
  near_mm = deck_marks()[0][1];
  layer(strip_bottom_z, strip_top_z) difference() {
    union() {
      translate(start_mm) rotate(strip_direction_deg) channel(strip_channel_mm + 2 * strip_wall_mm);
      hull() for (at_mm = [near_mm, start_mm]) translate(at_mm) disc(dimple_diameter_mm + 2);
    }
    translate(start_mm) rotate(strip_direction_deg) {
      channel(strip_channel_mm);
      // Opening at the far end, through which the strip is pushed onto the object.
      translate([-(cup_width_mm + slide_fit_mm) / 2, reach_length_mm])
        square([cup_width_mm + slide_fit_mm, 20]);
    }
  }
  translate([near_mm[0], near_mm[1], 0]) {
    scale([0.97, 0.97, 0.97]) dimple();
    layer(0.9, strip_bottom_z) disc(0.97 * dimple_diameter_mm, 24);
  }
}

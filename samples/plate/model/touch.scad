// Post on the wooden board for an infrared touch frame around the deck (four posts), or for a touch bar next to it
// (two). By default, the top of a post is level with the deck's face.

module touch_post() {
  foot_z = drum_bottom_z + lug_height_mm;
  translate(touch_post_at_mm) {
    layer(drum_bottom_z, foot_z) difference() {
      square([touch_post_mm, 3 * touch_post_mm], center = true);
      for (side = [-1, 1]) translate([0, side * touch_post_mm]) disc(4.5, hole_facets);
    }
    layer(foot_z, touch_level_mm) square(touch_post_mm, center = true);
    // Fence that prevents the frame from sliding outwards.
    layer(touch_level_mm, touch_level_mm + 5) translate([touch_post_mm / 2 - wall_mm / 2, 0])
        square([wall_mm, touch_post_mm], center = true);
  }
}

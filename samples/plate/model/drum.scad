// Wall between the deck and the wooden board under the plate.

module drum_outline(hole_mm) {
  difference() {
    union() {
      difference() {
        deck_outline();
        deck_outline(wall_mm);
      }
        intersection() {
        deck_outline();
        around(drum_screw_radius_mm, drum_directions_deg) union() {
          disc(drum_column_mm, 2 * hole_facets);
          translate([-drum_column_mm / 2, 0]) square([drum_column_mm, drum_column_mm]);
        }
      }
    }
    around(drum_screw_radius_mm, drum_directions_deg) disc(hole_mm, hole_facets);
  }
}

module cable_slot() around(deck_radius_mm - 10, [cable_direction_deg]) translate([-cable_width_mm / 2, 0])
    square([cable_width_mm, 20]);

module drum() {
  lug_z = drum_bottom_z + lug_height_mm;
  cable_z = drum_bottom_z + cable_height_mm;
  web_z = deck_bottom_z - drum_web_mm;
  layer(drum_bottom_z, lug_z) difference() {
    union() {
      drum_outline(m3_head_mm);
      difference() {
        around(lug_radius_mm, lug_directions_deg) union() {
          disc(lug_mm, 2 * hole_facets);
          translate([-lug_mm / 2, -lug_mm / 2]) square([lug_mm, lug_mm / 2]);
        }
        disc(2 * deck_radius_mm - wall_mm);
        around(lug_radius_mm, lug_directions_deg) disc(4.5, hole_facets);
      }
    }
    cable_slot();
  }
  layer(lug_z, cable_z) difference() {
    drum_outline(m3_head_mm);
    cable_slot();
  }
  layer(cable_z, web_z) drum_outline(m3_head_mm);
  layer(web_z, deck_bottom_z) drum_outline(m3_free_mm);
}

// What joins the plate to the bearing, and the bearing to the servo's horn.

module hub() {
  head_z = hub_bottom_z + m3_head_height_mm;
  layer(head_z, plate_bottom_z) difference() {
    disc(2 * hub_radius_mm);
    holes(m3_free_mm, hub_screw_circle_mm, hub_screws);
  }
  layer(hub_bottom_z, head_z) difference() {
    disc(2 * hub_radius_mm);
    holes(m3_head_mm, hub_screw_circle_mm, hub_screws);
    holes(m3_pilot_mm, retainer_screw_circle_mm, retainer_screws);
  }
  layer(floor_z, hub_bottom_z) difference() {
    disc(2 * land_radius_mm);
    holes(m3_pilot_mm, retainer_screw_circle_mm, retainer_screws);
  }
  layer(journal_bottom_z, floor_z) difference() {
    disc(bearing_bore_mm - bearing_fit_mm);
    holes(m3_pilot_mm, retainer_screw_circle_mm, retainer_screws);
  }
}

// Holds the hub down and carries the horn. The horn's screws have their heads in the upper side.
module retainer() {
  turned_deg = 180 / retainer_screws;  // the horn's screws lie between the retainer's
  head_z = bearing_bottom_z - m3_head_height_mm;
  layer(head_z, bearing_bottom_z) difference() {
    disc(2 * land_radius_mm);
    holes(m3_free_mm, retainer_screw_circle_mm, retainer_screws);
    rotate(turned_deg) holes(m3_head_mm, horn_hole_circle_mm, horn_holes);
  }
  layer(horn_top_z, head_z) difference() {
    disc(2 * land_radius_mm);
    holes(m3_free_mm, retainer_screw_circle_mm, retainer_screws);
    rotate(turned_deg) holes(m3_free_mm, horn_hole_circle_mm, horn_holes);
  }
  layer(retainer_bottom_z, horn_top_z) difference() {
    disc(2 * land_radius_mm);
    holes(m3_free_mm, retainer_screw_circle_mm, retainer_screws);
    disc(horn_diameter_mm + slide_fit_mm);
  }
}

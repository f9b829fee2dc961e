// Hub, which joins the plate to the bearing, and retainer, which joins the bearing to the servo's horn.

// Disc with holes on two circles and in its middle.
module pierced(diameter_mm, screw_mm, other_mm = 0, other_circle_mm = hub_screw_circle_mm, count = hub_screws, turned_deg = 0,
               middle_mm = 0) difference() {
  disc(diameter_mm);
  if (screw_mm > 0) holes(screw_mm, retainer_screw_circle_mm, retainer_screws);
  if (other_mm > 0) rotate(turned_deg) holes(other_mm, other_circle_mm, count);
  if (middle_mm > 0) disc(middle_mm);
}

module hub() {
  head_z = hub_bottom_z + m3_head_height_mm;
  layer(head_z, plate_bottom_z) pierced(2 * hub_radius_mm, 0, m3_free_mm);
  layer(hub_bottom_z, head_z) pierced(2 * hub_radius_mm, m3_pilot_mm, m3_head_mm);
  layer(floor_z, hub_bottom_z) pierced(2 * land_radius_mm, m3_pilot_mm);
  layer(journal_bottom_z, floor_z) pierced(bearing_bore_mm - bearing_fit_mm, m3_pilot_mm);
}

// Holds the hub down and carries the horn. The heads of the horn's screws are in the upper side. With a sensor the
// retainer has two discs, joined by two columns, with the magnet under the upper one and holes for heads in the lower one.
module retainer() {
  top_z = retainer_bottom_z + retainer_mm;
  // The horn's screws lie between the retainer's.
  module outline(screw_mm, horn_mm, middle_mm = 0)
      pierced(2 * land_radius_mm, screw_mm, horn_mm, horn_hole_circle_mm, horn_holes, 180 / retainer_screws, middle_mm);
  screw_mm = sensor_room_mm > 0 ? m3_head_mm : m3_free_mm;
  head_z = top_z - m3_head_height_mm;
  layer(head_z, top_z) outline(screw_mm, m3_head_mm);
  layer(horn_top_z, head_z) outline(screw_mm, m3_free_mm);
  layer(retainer_bottom_z, horn_top_z) outline(screw_mm, 0, horn_diameter_mm + slide_fit_mm);
  if (sensor_room_mm > 0) {
    layer(top_z, clamp_z) sensor_columns();
    layer(clamp_z, magnet_bottom_z + magnet_mm[1]) outline(m3_free_mm, 4.5, magnet_mm[0] + slide_fit_mm);
    layer(magnet_bottom_z + magnet_mm[1], bearing_bottom_z) outline(m3_free_mm, 4.5);
  }
}

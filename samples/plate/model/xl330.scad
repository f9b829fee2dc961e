// Parts for a Dynamixel XL330 instead of the hobby servo: a clamp that holds the sides of its body at any height, and a
// retainer for the horn of the XL330.

xl_front_z = horn_top_z - xl_horn_mm;
xl_band_top_z = retainer_bottom_z - 2;
xl_wall_mm = 4;
xl_slit_mm = 2;
xl_ear_mm = [6, 10];
xl_screw_y_mm = xl_shaft_mm - xl_height_mm - xl_wall_mm - 5;
xl_screw_z = xl_band_top_z - 6;

module xl_body(more_mm = 0) translate([0, xl_shaft_mm - xl_height_mm / 2])
    square([xl_width_mm + more_mm, xl_height_mm + more_mm], center = true);

module xl330_mount() {
  module floor_outline(hole_mm) difference() {
    hull() posts(2 * post_radius_mm + 2);
    posts(hole_mm);
    xl_body(2 * slide_fit_mm);
  }
  on_posts() floor_outline($hole_mm);
  difference() {
    layer(mount_top_z, xl_band_top_z) difference() {
      union() {
        xl_body(2 * xl_wall_mm);
        translate([-xl_ear_mm[0] - xl_slit_mm / 2, xl_shaft_mm - xl_height_mm - xl_wall_mm - xl_ear_mm[1]])
          square([2 * xl_ear_mm[0] + xl_slit_mm, xl_ear_mm[1] + 1]);
      }
      xl_body(2 * slide_fit_mm);
      translate([-xl_slit_mm / 2, -60]) square([xl_slit_mm, 60]);
    }
    // Holes for the screw that closes the band: clearance on the right, thread in plastic on the left.
    translate([0, xl_screw_y_mm, xl_screw_z]) rotate([0, 90, 0]) union() {
      cylinder(d = m3_free_mm, h = 20, $fn = hole_facets);
      rotate([180, 0, 0]) cylinder(d = m3_pilot_mm, h = 20, $fn = hole_facets);
    }
  }
}

module xl330_retainer() {
  m2_head_z = bearing_bottom_z - m2_head_height_mm;
  module outline(horn_hole_mm, horn_mm) pierced(2 * land_radius_mm, m3_free_mm, horn_hole_mm, xl_horn_circle_mm, horn_holes,
      180 / retainer_screws, horn_mm);
  layer(m2_head_z, bearing_bottom_z) outline(m2_head_mm, 0);
  layer(horn_top_z, m2_head_z) outline(m2_free_mm, 0);
  layer(retainer_bottom_z, horn_top_z) outline(m2_free_mm, xl_horn_diameter_mm + slide_fit_mm);
}

module xl330() layer(xl_front_z - xl_depth_mm, xl_front_z) xl_body();

module xl330_horn() layer(xl_front_z + 0.3, horn_top_z) difference() {
  disc(xl_horn_diameter_mm);
  rotate(180 / retainer_screws) holes(1.6, xl_horn_circle_mm, horn_holes);
}

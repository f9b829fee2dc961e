// Plate that turns, at orientation 0: its ridges are along X, and their normal is on the mid-line.

// Ridges at odd multiples of half the spacing, so that centre and start are between two of them.
function ridges_y_mm() =
    let(reach_mm = plate_radius_mm - ridge_margin_mm - ridge_width_mm)
    [for (i = [0:floor((reach_mm / ridge_spacing_mm) - 0.5)]) for (side = [-1, 1]) side * (i + 0.5) * ridge_spacing_mm];

module plate_outline() {
  difference() {
    disc(plate_diameter_mm);
    // Half a hole for the zero pin, in the direction of the ridges' normal. It is also the pointer on the scale.
    translate([0, zero_pin_radius_mm]) disc(zero_pin_mm + slide_fit_mm, hole_facets);
  }
}

module ridges() {
  intersection() {
    disc(plate_diameter_mm - 2 * ridge_margin_mm);
    for (y_mm = ridges_y_mm()) translate([-plate_radius_mm, y_mm - ridge_width_mm / 2])
      square([plate_diameter_mm, ridge_width_mm]);
  }
}

// Cap of a sphere. Its lowest point is dimple_depth_mm below the origin.
module dimple() {
  radius_mm = dimple_diameter_mm / 2;
  sphere_mm = (radius_mm * radius_mm + dimple_depth_mm * dimple_depth_mm) / (2 * dimple_depth_mm);
  half_deg = asin(radius_mm / sphere_mm);
  steps = 5;
  rotate_extrude($fn = 24) polygon(concat(
      [[0, -dimple_depth_mm]],
      [for (i = [1:steps]) [sphere_mm * sin(half_deg * i / steps),
                            sphere_mm - dimple_depth_mm - sphere_mm * cos(half_deg * i / steps)]],
      [[radius_mm, 1], [0, 1]]));
}

module plate() {
  difference() {
    union() {
      layer(plate_bottom_z, plate_pilot_z) difference() {
        plate_outline();
        holes(m3_pilot_mm, hub_screw_circle_mm, hub_screws);
      }
      layer(plate_pilot_z, 0) plate_outline();
      layer(0, crest_z) ridges();
    }
    translate([0, -start_distance_mm, 0]) dimple();
  }
}

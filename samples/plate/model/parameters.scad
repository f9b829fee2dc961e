// Dimensions of the plate and its mount. Millimetres and degrees.
//
// Axes: +X to the user's right, +Y along the mid-line away from the user, +Z up. The origin is the plate's
// centre, on its face between the ridges. Plate coordinates, as in plugin/include/haptic_retargeting/base.h,
// are (X, Z, -Y) / 1000. Directions are counter-clockwise from +Y, seen from above.

/* [Plate] */
plate_diameter_mm = 150;
plate_thickness_mm = 8;
ridge_height_mm = 1;
ridge_width_mm = 1;
ridge_spacing_mm = 10;
// Distance from the ends of the ridges to the rim.
ridge_margin_mm = 1;

/* [Marks] */
// Distance of the start from the centre, towards the user.
start_distance_mm = 50;
dimple_diameter_mm = 8;
dimple_depth_mm = 1;

/* [Fits: measure a test print, see README.md] */
// Added to the diameter of a hole that a part slides into.
slide_fit_mm = 0.2;
// Added to the bearing's outer diameter for the hole in the deck; subtracted from its bore for the hub.
bearing_fit_mm = 0.1;
// Gap between the plate's rim and the deck.
rim_gap_mm = 1;

/* [Bearing: 61808, also sold as 6808] */
bearing_bore_mm = 40;
bearing_outer_mm = 52;
bearing_width_mm = 7;
// Width of the ring's face that a shoulder may touch.
bearing_land_mm = 1.5;

/* [Servo: standard size. Measure yours] */
servo_length_mm = 40.9;
servo_width_mm = 20;
servo_flange_length_mm = 54;
servo_flange_thickness_mm = 2.5;
servo_below_flange_mm = 26.8;
servo_above_flange_mm = 7.7;
servo_hole_length_mm = 49.5;
servo_hole_width_mm = 10;
// Distance from the middle of the body to the shaft.
servo_shaft_offset_mm = 10.15;
// Height from the upper face of the flange to the top of the mounted horn.
horn_top_above_flange_mm = 15;

/* [Horn: round, with tapped M3 holes] */
horn_diameter_mm = 20;
horn_hole_circle_mm = 14;
horn_holes = 4;
horn_pocket_mm = 1.5;
// Clearance between shaft and horn's end, so that the shaft does not push the plate up.
horn_slack_mm = 0.5;

/* [Sensor of a hobby servo: an AS5600 board of 23 x 23 mm, its chip in the middle] */
// Height between hub and servo for the sensor: 14, or 0 without a sensor.
sensor_room_mm = 0;
sensor_board_mm = [23.2, 1.6];
magnet_mm = [6, 2.5];
// Gap between magnet and chip. The chip is assumed to have the same height.
magnet_gap_mm = 1.5;

/* [Dynamixel XL330. Measure yours] */
xl_width_mm = 20;
xl_height_mm = 34;
// Depth of the body, without the horn.
xl_depth_mm = 23;
// Distance from the nearer end of the body to the shaft.
xl_shaft_mm = 9.5;
// Height from the body to the horn's top.
xl_horn_mm = 2.8;
xl_horn_diameter_mm = 16;
xl_horn_circle_mm = 12;

/* [Real object] */
object_diameter_mm = 10;
object_height_mm = 40;
// Gap between the crests of the ridges and the object's lower end.
object_gap_mm = 2;
reach_length_mm = 100;
object_directions_deg = [-10, -5, 0, 5, 10];

/* [Registration: cup and strip] */
// Radius of the cup, into which a fingertip fits.
cup_radius_mm = 9;
cup_width_mm = 14;
cup_lip_mm = 1;
strip_channel_mm = 18;
// Direction, from the start, of the object to which the strip leads.
strip_direction_deg = 0;
strip_wall_mm = 3;
strip_mm = 6;
// Length over which the channel narrows to the object.
strip_lead_mm = 6;

/* [Box of the stop button: measure button, fuse holder and board] */
box_mm = [130, 90, 55];
stop_hole_mm = 22.4;
fuse_hole_mm = 12.4;
// Distance between the ties of an Arduino Uno, or of the U2D2 with its hub.
board_ties_mm = 58;

/* [Hidden] */
// Numbers of corners of a large circle and of a hole. A multiple of 4 gives exact diameters along X and Y.
facets = 120;
hole_facets = 16;

// Screws M3 and M2: free hole for the shaft, pilot hole in plastic that the thread cuts into, hole for the head.
m3_free_mm = 3.4;
m3_pilot_mm = 2.6;
m3_head_mm = 6.6;
m3_head_height_mm = 2.5;
m2_free_mm = 2.4;
m2_head_mm = 4.4;
m2_head_height_mm = 1.5;

plate_radius_mm = plate_diameter_mm / 2;
deck_inner_radius_mm = plate_radius_mm + rim_gap_mm;
deck_radius_mm = deck_inner_radius_mm + 19;
// Width between the flats, with which deck and drum fit cornerwise on the bed of a small printer.
deck_flats_mm = 178;
mark_radius_mm = deck_inner_radius_mm + 10;

hub_radius_mm = 33;
hub_screw_circle_mm = 54;
hub_screws = 6;
hub_flange_mm = 5;
hub_screw_mm = 8;
shoulder_mm = 1;
land_radius_mm = bearing_bore_mm / 2 + bearing_land_mm;

retainer_mm = 7;
retainer_screw_circle_mm = 32;
retainer_screws = 4;

lip_mm = 2;
engraving_mm = 0.6;
zero_pin_mm = 3;
zero_pin_radius_mm = plate_radius_mm + rim_gap_mm / 2;

post_radius_mm = 5;
post_x_mm = 28;
post_y_mm = [14, -34];
mount_mm = 5;
mount_recess_mm = sensor_room_mm > 0 ? 3 : 2;  // for screws of 50 mm with a sensor, of 30 mm without
// Wide holes, in which the mount is moved until the shaft is on the axis. Washers cover them.
post_hole_mm = 4;
post_washer_mm = 7.6;

wall_mm = 3;
drum_directions_deg = [0, 60, 120, 180, 240, 300];
drum_screw_radius_mm = deck_radius_mm - 8.5;
drum_column_mm = 11;
drum_web_mm = 8;
drum_pilot_mm = 9;
lug_directions_deg = [0, 90, 180, 270];
lug_radius_mm = deck_radius_mm + 7;
lug_mm = 16;
lug_height_mm = 4;
cable_direction_deg = 30;
cable_width_mm = 14;
cable_height_mm = 14;

touch_post_mm = 18;
touch_post_at_mm = [109, 75];  // middle of a post, under the side of a frame with an opening of 194 mm
touch_level_mm = 0;            // height of a post's top above the deck's face

bridge_directions_deg = [-20, 20];
bridge_radius_mm = deck_inner_radius_mm + 10;
bridge_column_mm = 12;
tenon_mm = 8;
tenon_depth_mm = 8;
tenon_web_mm = 3;
head_mm = 6;
socket_mm = 6;
socket_depth_mm = 2;
object_pilot_mm = 13;

// Heights. Layers that touch use the same variable for their common height, so that no slit is left between them.
crest_z = ridge_height_mm;
plate_bottom_z = -plate_thickness_mm;
plate_pilot_z = plate_bottom_z + hub_screw_mm - (hub_flange_mm - m3_head_height_mm) + 0.5;
hub_bottom_z = plate_bottom_z - hub_flange_mm;
floor_z = hub_bottom_z - shoulder_mm;              // floor of the deck, and top of the bearing
bearing_bottom_z = floor_z - bearing_width_mm;
journal_bottom_z = bearing_bottom_z + 0.2;         // the retainer clamps the bearing's inner ring
deck_bottom_z = bearing_bottom_z - lip_mm;
clamp_z = bearing_bottom_z - retainer_mm;          // heads of the screws that hold the hub
retainer_bottom_z = clamp_z - (sensor_room_mm > 0 ? sensor_room_mm + retainer_mm : 0);
magnet_bottom_z = clamp_z + 1 - magnet_mm[1];      // in a pocket 1 mm deep
sensor_arm_z = magnet_bottom_z - 2 * magnet_gap_mm - sensor_board_mm[1];
sensor_arm_mm = 4;
horn_top_z = retainer_bottom_z + horn_pocket_mm;
flange_top_z = horn_top_z - horn_top_above_flange_mm - horn_slack_mm;
mount_top_z = flange_top_z - servo_flange_thickness_mm;
mount_bottom_z = mount_top_z - mount_mm;
servo_bottom_z = mount_top_z - servo_below_flange_mm;
drum_bottom_z = servo_bottom_z - 7;
object_bottom_z = crest_z + object_gap_mm;
head_bottom_z = object_bottom_z + object_height_mm;
head_top_z = head_bottom_z + head_mm;

module layer(bottom_z, top_z) {
  assert(top_z > bottom_z, str("a layer from ", bottom_z, " to ", top_z, " mm has no height"));
  translate([0, 0, bottom_z]) linear_extrude(height = top_z - bottom_z) children();
}

module disc(diameter_mm, corners = facets) circle(d = diameter_mm, $fn = corners);

function at_direction(radius_mm, direction_deg) =
    [-radius_mm * sin(direction_deg), radius_mm * cos(direction_deg)];

// Outline of deck and drum, reduced by `inside_mm`: a disc with four flats.
module deck_outline(inside_mm = 0) intersection() {
  disc(2 * (deck_radius_mm - inside_mm));
  rotate(45) square(deck_flats_mm - 2 * inside_mm, center = true);
}

// Copies of the children in each direction, with their +Y outwards.
module around(radius_mm, directions_deg) {
  for (direction_deg = directions_deg)
    translate(at_direction(radius_mm, direction_deg)) rotate(direction_deg) children();
}

module holes(diameter_mm, circle_mm, count) {
  around(circle_mm / 2, [for (i = [0:count - 1]) i * 360 / count]) disc(diameter_mm, hole_facets);
}

assert(ridge_spacing_mm > ridge_width_mm, "ridge_spacing_mm must be above ridge_width_mm");
assert(ridge_width_mm > 0 && ridge_height_mm > 0, "ridge_width_mm and ridge_height_mm must be above 0");
assert(dimple_depth_mm < dimple_diameter_mm / 2, "dimple_depth_mm must be below half of dimple_diameter_mm");
assert(start_distance_mm + dimple_diameter_mm / 2 < plate_radius_mm - ridge_margin_mm,
       "start_distance_mm must leave the start's dimple on the plate; decrease it");
assert(plate_pilot_z < -1.5, "plate_thickness_mm must leave 1.5 mm above the screws of the hub; increase it");
assert(dimple_diameter_mm <= 10, "dimple_diameter_mm must be 10 or less: the marks would meet the scale");
assert(horn_diameter_mm + slide_fit_mm < retainer_screw_circle_mm - m3_head_mm,
       "horn_diameter_mm must leave room for the retainer's screws; decrease it");
assert(rim_gap_mm <= 4, "rim_gap_mm must be 4 or less: wider gaps admit a fingertip");
assert(object_gap_mm >= 1 && object_gap_mm <= 4,
       "object_gap_mm must be 1 to 4: with less, the object may rub; with more, a fingertip fits in");
assert(cup_width_mm < 2 * cup_radius_mm, "cup_width_mm must be below twice cup_radius_mm");
assert(sensor_room_mm == 0 || sensor_room_mm >= clamp_z - sensor_arm_z + sensor_arm_mm + 3,
       "sensor_room_mm must be 0, or at least 14 to leave 3 mm below the sensor's arm");
assert(facets % 4 == 0, "facets must be a multiple of 4");

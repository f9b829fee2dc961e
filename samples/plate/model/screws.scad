// Table of screws: name, part that they pass, part with their thread, length, height of the face under the head,
// positions, and whether the hobby servo's list of parts counts them. The head is above if the length is negative.

function circle_of(radius_mm, count, first_deg = 0) =
    [for (i = [0:count - 1]) at_direction(radius_mm, first_deg + 360 * i / count)];
posts_mm = [for (x_mm = [-post_x_mm, post_x_mm], y_mm = post_y_mm) [x_mm, y_mm]];
servo_holes_mm = [for (x_mm = [-0.5, 0.5] * servo_hole_width_mm, y_mm = [-0.5, 0.5] * servo_hole_length_mm)
    [x_mm, y_mm - servo_shaft_offset_mm]];

function table_of_screws() = [
  ["hub", "hub", "plate", 8, hub_bottom_z + m3_head_height_mm, circle_of(hub_screw_circle_mm / 2, hub_screws), true],
  ["horn", "retainer", "horn", -6, retainer_bottom_z + retainer_mm - m3_head_height_mm, circle_of(horn_hole_circle_mm / 2, horn_holes, 45), true],
  ["retainer", "retainer", "hub", 16, clamp_z, circle_of(retainer_screw_circle_mm / 2, retainer_screws), true],
  ["servo", "servo", "servo_mount", -8, flange_top_z + 0.5, servo_holes_mm, true],
  ["mount", "servo_mount", "deck", sensor_room_mm > 0 ? 50 : 30, mount_bottom_z + mount_recess_mm, posts_mm, true],
  ["xl330_retainer", "xl330_retainer", "hub", 16, retainer_bottom_z, circle_of(retainer_screw_circle_mm / 2, retainer_screws), false],
  ["xl330_mount", "xl330_mount", "deck", 30, mount_bottom_z + mount_recess_mm, posts_mm, false],
  ["sensor_arm", "sensor_arm", "deck", 16, deck_bottom_z - 9, sensor_posts_mm, true],
  ["object", "bridge", "object", -16, head_top_z, [object_at(0)], true],
  ["object_cup", "bridge", "object_cup", -16, head_top_z, [object_at(0)], false],
  ["bridge", "deck", "bridge", 16, -tenon_depth_mm - tenon_web_mm, [for (d = bridge_directions_deg) at_direction(bridge_radius_mm, d)], true],
  ["drum", "drum", "deck", 16, deck_bottom_z - drum_web_mm, [for (d = drum_directions_deg) at_direction(drum_screw_radius_mm, d)], true],
];

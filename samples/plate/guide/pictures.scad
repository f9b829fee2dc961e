// The guide's pictures: openscad -D 'picture="step_1"' -o step_1.png --viewall --autocenter pictures.scad
// New parts of a step are blue; screws are orange and away from their holes.
picture = "overview";
view = [58, 0, -28];  // rotation of the view, degrees
include <../model/apparatus.scad>
part = "none";
sensor_room_mm = picture == "sensor" ? 14 : 0;

// Position in the picture (x to the right, y upwards) of a point of the model. A label has a line to its point.
function seen(at_mm) = let (turn = view[2], tilt = view[0], x = at_mm[0] * cos(turn) + at_mm[1] * sin(turn),
                            y = at_mm[1] * cos(turn) - at_mm[0] * sin(turn)) [x, y * cos(tilt) + at_mm[2] * sin(tilt)];
label_edge = picture == "overview" ? 260 : picture == "touch" ? 190 : 118;
module label(words, at_mm, label_x = label_edge, label_y = undef) let (point = seen(at_mm), y = is_undef(label_y) ? point[1] : label_y)
  color("#111827") rotate(view) translate([0, 0, 110]) linear_extrude(0.1) {
    hull() for (end = [point, [label_x - 2, y]]) translate(end) circle(d = 0.5, $fn = 8);
    translate(point) circle(d = 2, $fn = 16);
    translate([label_x, y]) text(words, size = 6, valign = "center");
  }
// Points of the labels: name, text, distance from the axis to the right in the picture, height, and distance by which the
// label is moved downwards.
pointed = [["plate", "plate", 72, -4], ["hub", "hub", 24, hub_bottom_z + 2, 9], ["bearing", "bearing 61808", 24, bearing_bottom_z + 3, 9],
    ["deck", "deck", 92, deck_bottom_z + 6, picture == "marks" ? 9 : 0], ["retainer", "retainer", 20, retainer_bottom_z + 2], ["horn", "horn", 8, horn_top_z - 8, 6],
    ["servo_mount", "servo mount", 30, mount_bottom_z + 2], ["servo", "hobby servo", 9, servo_bottom_z + 8], ["bridge", "bridge", 30, head_top_z - 4],
    ["object", "object", 4, object_bottom_z + 20], ["drum", "drum", 88, drum_bottom_z + 20], ["box", "box", 60, drum_bottom_z + 20],
    ["xl330_mount", "XL330 mount", 30, mount_bottom_z + 2], ["xl330_retainer", "XL330 retainer", 20, retainer_bottom_z + 2],
    ["xl330", "XL330", 6, horn_top_z - 18]];
module labels(names, lift_mm) for (name = names, row = pointed) if (row[0] == name)
  let (at_mm = [row[2] * cos(view[2]), row[2] * sin(view[2]), row[3] + lift_mm] + (name == "object" || name == "bridge" ? [0, object_at(0)[1], 0] : [0, 0, 0]))
    label(row[1], at_mm, label_y = seen(at_mm)[1] - (is_undef(row[4]) ? 0 : row[4]));

module placed(names, lift_mm = 0, paint = "#d1d5db") {
  color(paint) translate([0, 0, lift_mm]) for (name = names) installed(name);
  labels(len(names) < 3 || lift_mm != 0 ? names : ["deck", "plate"], lift_mm);
}
module new(names, lift_mm = 0) placed(names, lift_mm, "#60a5fa");

// Screws with heads, shafts and the lines to their holes.
module screws(name, lift_mm) {
  screws_without_label(name, lift_mm);
  for (row = table_of_screws()) if (row[0] == name)
    label(str(len(row[5]), " × M3 × ", abs(row[3])), [row[5][0][0], row[5][0][1], row[4] + lift_mm + (lift_mm < 0 ? -8 : 2)]);
}
module screws_without_label(name, lift_mm) for (row = table_of_screws()) if (row[0] == name) for (at_mm = row[5]) translate(at_mm) {
  length_mm = row[3];
  color("#d97706") translate([0, 0, row[4] + lift_mm]) {
    translate([0, 0, length_mm > 0 ? -2.4 : 0]) cylinder(d = 5.5, h = 2.4);
    translate([0, 0, min(0, length_mm)]) cylinder(d = 3, h = abs(length_mm));
  }
  color("#fbbf24") translate([0, 0, row[4] + min(0, lift_mm)]) cylinder(d = 0.8, h = abs(lift_mm));
}
module pin(lift_mm) {
  color("#d97706") translate([0, 75.5, lift_mm - 21]) cylinder(d = 3, h = 40);
  label("zero pin", [0, 75.5, lift_mm + 15]);
}

sensor_words = ["plate", "hub", "bearing 61808", "deck", "magnet", "AS5600", "sensor arm", "retainer", "hobby servo"];
// Colours of the parts in a flat section along the mid-line, with the user at the left.
paints = [["plate", "#60a5fa"], ["hub", "#6ee7b7"], ["bearing", "#a1a1aa"], ["deck", "#fca5a5"]];
xl330_paints = [["xl330_retainer", "#fde68a"], ["xl330_horn", "#9ca3af"], ["xl330", "#64748b"], ["xl330_mount", "#c4b5fd"], ["drum", "#e5e7eb"]];
held_paints = [["bridge", "#fdba74"], ["object", "#fcd34d"]];
sensor_paints = [["sensor_arm", "#c4b5fd"], ["retainer", "#fde68a"], ["horn", "#9ca3af"], ["servo", "#64748b"]];
module upright(width_mm, bottom_z, height_mm, paint) color(paint) linear_extrude(1) translate([-width_mm / 2, bottom_z]) square([width_mm, height_mm]);
module section(rows) {
  section_without_labels(rows);
  section_labels(rows);
}
module section_labels(rows)
  for (i = [0:len(rows) - 1], row = pointed) if (row[0] == rows[i][0])
    label(row[1], [row[2], row[3], 0] + (rows[i][0] == "object" || rows[i][0] == "bridge" ? [-object_at(0)[1] - row[2], 0, 0] : [0, 0, 0]), label_edge, 40 - 9 * i);
module section_without_labels(rows) for (row = rows)
  color(row[1]) linear_extrude(1) projection(cut = true) rotate([0, 0, 90]) rotate([0, 90, 0]) translate([0.02, 0, 0]) installed(row[0]);

if (picture == "step_1") { placed(["plate"]); new(["hub"], -30); screws("hub", -55); }
if (picture == "step_2") { placed(["deck"]); new(["bearing"], 45); }
if (picture == "step_3") { placed(["deck", "bearing"]); new(["plate", "hub"], 45); pin(75); }
if (picture == "step_4") { placed(["horn"], -22); new(["retainer"]); screws("horn", 22); }
if (picture == "step_5") { placed(["deck", "bearing", "hub", "plate"]); new(["retainer", "horn"], -32); screws("retainer", -62); }
if (picture == "step_6") { placed(["servo_mount"]); new(["servo"], 55); screws("servo", 85); }
if (picture == "step_7") {
  placed(["deck", "bearing", "hub", "plate", "retainer", "horn"]);
  new(["servo_mount", "servo"], -55);
  screws("mount", -95);
  pin(0);
}
if (picture == "step_7_xl330") {
  placed(["deck", "bearing", "hub", "plate"]);
  new(["xl330_retainer", "xl330_horn", "xl330"], -40);
  new(["xl330_mount"], -95);
  screws("xl330_mount", -135);
}
if (picture == "step_8") {
  placed(["deck", "plate"]);
  new(["bridge"], 35);
  new(["object"], 22);
  screws("object", 60);
  screws("bridge", -45);
}
if (picture == "step_9") {
  placed(["deck", "plate", "xl330_mount", "xl330", "bearing", "hub", "bridge"]);
  new(["drum"], -75);
  screws("drum", -150);
}
if (picture == "overview") { placed(["drum", "deck", "bridge", "box"]); new(["plate"]); placed(["object"], 0, "#d97706");
  labels(["drum"], 0); label("bridge", [5, object_at(0)[1] + 5, head_top_z]); label("box", [box_middle_mm[0] + 40, -35, box_top_z], label_y = -30); }
if (picture == "marks") {
  color("#d1d5db") installed("deck");
  color("#60a5fa") installed("plate");
  for (mark = concat([["start", [0, -start_distance_mm]]], deck_marks()))
    label(mark[0], [mark[1][0], mark[1][1], 0], label_edge, seen([mark[1][0], mark[1][1], 0])[1] + (mark[1][0] < -1 ? 8 : mark[1][0] < 1 ? -4 : 0));
}
// A frame of 15.6 inches: an opening of 194 by 344 mm.
if (picture == "touch") {
  placed(["drum", "deck", "plate", "bridge"]);
  color("#d97706") installed("object");
  color("#60a5fa") for (x = [0, 1], y = [0, 1]) mirror([x, 0, 0]) mirror([0, y, 0]) installed("touch_post");
  label("4 touch posts", [touch_post_at_mm[0], -touch_post_at_mm[1], drum_bottom_z + 30], label_y = -90);
  color("#374151", 0.6) translate([0, 0, touch_level_mm]) linear_extrude(8) difference() {
    square([218, 368], center = true);
    square([194, 344], center = true);
  }
  label("infrared touch frame", [103, 120, touch_level_mm + 8]);
}
if (picture == "section") section(concat(held_paints, paints, xl330_paints));
if (picture == "sensor") {
  intersection() {
    section_without_labels(concat(paints, sensor_paints));
    translate([-50, -60, -1]) cube([100, 62, 3]);
  }
  for (i = [0:8], row = [["plate", 46, -4], ["hub", 16, -16], ["bearing 61808", 24, bearing_bottom_z + 3], ["deck", 46, deck_bottom_z + 6],
      ["magnet", 2, magnet_bottom_z + 1], ["AS5600", 8, sensor_arm_z + 1], ["sensor arm", -30, sensor_arm_z - 2],
      ["retainer", 10, retainer_bottom_z + 4], ["hobby servo", 12, servo_bottom_z + 36]]) if (row[0] == sensor_words[i])
    label(row[0], [row[1], row[2], 0], 62, 8 - 9 * i);
  upright(magnet_mm[0], magnet_bottom_z, magnet_mm[1], "#dc2626");
  upright(sensor_board_mm[0], sensor_arm_z, sensor_board_mm[1], "#15803d");
  upright(4, sensor_arm_z + sensor_board_mm[1], magnet_gap_mm, "#15803d");
}

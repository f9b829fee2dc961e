// The guide's pictures: openscad -D 'picture="step_1"' -o step_1.png --viewall --autocenter pictures.scad
// A step's own parts are blue, screws orange and away from their place.
picture = "overview";
include <../model/apparatus.scad>
part = "none";
sensor_room_mm = picture == "sensor" ? 14 : 0;

module placed(names, lift_mm = 0, paint = "#d1d5db") color(paint) translate([0, 0, lift_mm]) for (name = names) installed(name);
module new(names, lift_mm = 0) placed(names, lift_mm, "#60a5fa");

// Their heads, shafts and the way to their place.
module screws(name, lift_mm) for (row = table_of_screws()) if (row[0] == name) for (at_mm = row[5]) translate(at_mm) {
  length_mm = row[3];
  color("#d97706") translate([0, 0, row[4] + lift_mm]) {
    translate([0, 0, length_mm > 0 ? -2.4 : 0]) cylinder(d = 5.5, h = 2.4);
    translate([0, 0, min(0, length_mm)]) cylinder(d = 3, h = abs(length_mm));
  }
  color("#fbbf24") translate([0, 0, row[4] + min(0, lift_mm)]) cylinder(d = 0.8, h = abs(lift_mm));
}
module pin(lift_mm) color("#d97706") translate([0, 75.5, lift_mm - 21]) cylinder(d = 3, h = 40);

// Of a cut along the mid-line, the user to the left; flat.
paints = [["plate", "#60a5fa"], ["hub", "#6ee7b7"], ["bearing", "#a1a1aa"], ["deck", "#fca5a5"]];
xl330_paints = [["xl330_retainer", "#fde68a"], ["xl330_horn", "#9ca3af"], ["xl330_mount", "#c4b5fd"], ["xl330", "#64748b"],
    ["drum", "#e5e7eb"], ["bridge", "#fdba74"], ["object", "#fcd34d"]];
sensor_paints = [["retainer", "#fde68a"], ["horn", "#9ca3af"], ["servo", "#64748b"], ["sensor_arm", "#c4b5fd"]];
module upright(width_mm, bottom_z, height_mm, paint) color(paint) linear_extrude(1) translate([-width_mm / 2, bottom_z]) square([width_mm, height_mm]);
module section(rows) for (row = rows)
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
if (picture == "overview") { placed(["drum", "deck", "bridge", "box"]); new(["plate"]); placed(["object"], 0, "#d97706"); }
if (picture == "marks") { placed(["deck"]); new(["plate"]); }
if (picture == "section") section(concat(paints, xl330_paints));
if (picture == "sensor") {
  intersection() {
    section(concat(paints, sensor_paints));
    translate([-50, -60, -1]) cube([100, 62, 3]);
  }
  upright(magnet_mm[0], magnet_bottom_z, magnet_mm[1], "#dc2626");
  upright(sensor_board_mm[0], sensor_arm_z, sensor_board_mm[1], "#15803d");
  upright(4, sensor_arm_z + sensor_board_mm[1], magnet_gap_mm, "#15803d");
}

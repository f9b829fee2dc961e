// The ridged plate and its mount: one part, ready to print, or all of them in place.
//
//   openscad -o plate.stl -D 'part="plate"' apparatus.scad
//
// README.md lists the parts. Any dimension of parameters.scad may be set in the same way: -D ridge_spacing_mm=8

part = "all";  // [all, plate, hub, retainer, deck, drum, servo_mount, sensor_arm, bridge, object, object_cup, strip, box, touch_post, xl330_mount, xl330_retainer, bearing, servo, horn, xl330, xl330_horn, tables, none]
servo_is = "xl330";  // [xl330, hobby] in "all"

include <parameters.scad>
include <lettering.scad>
include <plate.scad>
include <marks.scad>
include <hub.scad>
include <deck.scad>
include <drum.scad>
include <servo_mount.scad>
include <sensor.scad>
include <bridge.scad>
include <registration.scad>
include <bought.scad>
include <xl330.scad>
include <box.scad>
include <touch.scad>
include <screws.scad>

// Parts: name, height that lies on the printer's bed, and rotations for printing about Y and then about Z.
parts = [
  ["plate", plate_bottom_z, 0, 0],
  ["hub", plate_bottom_z, 180, 0],
  ["retainer", bearing_bottom_z, 180, 0],
  ["deck", deck_bottom_z, 0, 45],
  ["drum", drum_bottom_z, 0, 45],
  ["servo_mount", mount_bottom_z, 0, 0],
  ["sensor_arm", sensor_arm_z - sensor_arm_mm, 0, 0],
  ["bridge", head_top_z, 180, 0],
  ["object", object_bottom_z, 0, 0],
  ["object_cup", object_bottom_z, 0, 0],
  ["strip", strip_top_z, 180, 0],
  ["box", box_top_z, 180, 0],
  ["touch_post", drum_bottom_z, 0, 0],
  ["xl330_mount", mount_bottom_z, 0, 0],
  ["xl330_retainer", bearing_bottom_z, 180, 0],
];
of_xl330 = ["xl330_mount", "xl330_retainer", "xl330", "xl330_horn"];
of_hobby_servo = ["servo_mount", "retainer", "servo", "horn"];

module installed(name) {
  if (name == "plate") plate();
  else if (name == "hub") hub();
  else if (name == "retainer") retainer();
  else if (name == "deck") deck();
  else if (name == "drum") drum();
  else if (name == "servo_mount") servo_mount();
  else if (name == "sensor_arm") sensor_arm();
  else if (name == "bridge") bridge();
  else if (name == "object") object();
  else if (name == "object_cup") object_cup();
  else if (name == "strip") strip();
  else if (name == "box") box();
  else if (name == "touch_post") touch_post();
  else if (name == "bearing") bearing();
  else if (name == "servo") servo();
  else if (name == "horn") horn();
  else if (name == "xl330_mount") xl330_mount();
  else if (name == "xl330_retainer") xl330_retainer();
  else if (name == "xl330") xl330();
  else if (name == "xl330_horn") xl330_horn();
  else assert(false, str("part is \"", name, "\"; it must be one of the list in apparatus.scad"));
}

if (part == "all") {
  left_out = concat(["object_cup", "strip", "box", "touch_post", "sensor_arm"], servo_is == "xl330" ? of_hobby_servo : of_xl330);
  for (name = concat([for (row = parts) row[0]], ["bearing", "servo", "horn", "xl330", "xl330_horn"]))
    if (search([name], left_out)[0] == []) installed(name);
} else if (part == "tables") {
  marks_table();
  for (row = parts) echo(str("bed", row));
  for (row = table_of_screws()) echo(str("screw", row));
} else if (part != "none") {
  found = search([part], parts)[0];
  if (is_num(found)) {
    // Rotation about Y keeps the mid-line.
    rotate([0, parts[found][2], parts[found][3]]) translate([0, 0, -parts[found][1]]) installed(part);
  } else {
    installed(part);
  }
}

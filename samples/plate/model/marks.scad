// Marks that a registration touches: the lowest points of the dimples.

// Marks of the deck: name and position (x, y), valid at every orientation of the plate.
function deck_marks() = [
  ["near", at_direction(mark_radius_mm, 180)],
  ["near right", at_direction(mark_radius_mm, -120)],
  ["far right", at_direction(mark_radius_mm, -60)],
  ["far left", at_direction(mark_radius_mm, 60)],
  ["near left", at_direction(mark_radius_mm, 120)],
];

// Row of marks.csv: plate coordinates (X, Z, -Y) in metres.
function marks_line(name, at_mm, orientation) =
    str(name, ",", at_mm[0] / 1000, ",", -dimple_depth_mm / 1000, ",", -at_mm[1] / 1000, ",", orientation);

module marks_table() {
  echo("name,x_m,y_m,z_m,plate_orientation");
  echo(marks_line("start", [0, -start_distance_mm], "0"));
  for (mark = deck_marks()) echo(marks_line(mark[0], mark[1], "any"));
}

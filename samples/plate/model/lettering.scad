// Letters of straight strokes, 4 mm high, for engraving. They do not depend on the installed fonts.

letter_stroke_mm = 0.8;
letter_advance_mm = 3.6;

letters = [
  ["0", [[[0, 0], [2, 0], [2, 4], [0, 4], [0, 0]]]],
  ["4", [[[0, 4], [0, 2], [2, 2]], [[2, 4], [2, 0]]]],
  ["5", [[[2, 4], [0, 4], [0, 2], [2, 2], [2, 0], [0, 0]]]],
  ["9", [[[2, 2], [0, 2], [0, 4], [2, 4], [2, 0], [0, 0]]]],
  ["+", [[[0, 2], [2, 2]], [[1, 1], [1, 3]]]],
  ["-", [[[0, 2], [2, 2]]]],
  ["U", [[[0, 4], [0, 0], [2, 0], [2, 4]]]],
  ["S", [[[2, 4], [0, 4], [0, 2], [2, 2], [2, 0], [0, 0]]]],
  ["E", [[[2, 4], [0, 4], [0, 0], [2, 0]], [[0, 2], [2, 2]]]],
  ["R", [[[0, 0], [0, 4], [2, 4], [2, 2], [0, 2]], [[1, 2], [2, 0]]]],
];

// Text centred on X, with its baseline at Y = 0.
module lettering(words) {
  width_mm = (len(words) - 1) * letter_advance_mm + 2;
  for (i = [0:len(words) - 1]) {
    strokes = letters[search([words[i]], letters)[0]][1];
    translate([i * letter_advance_mm - width_mm / 2, letter_stroke_mm / 2])
      for (stroke = strokes, corner = [1:len(stroke) - 1]) hull() {
        for (at_mm = [stroke[corner - 1], stroke[corner]])
          translate(at_mm) square(letter_stroke_mm, center = true);
      }
  }
}

#!/usr/bin/env python3
"""Draws the wiring of both plates: writes wiring_xl330.svg and wiring_hobby.svg to its own folder.

A part is a box with its pins at the lower edge. A net is a horizontal line, and a dot on it joins a pin to the net. Wires
that cross without a dot do not touch. tests/samples/plate/model/model_test compares the nets with the firmware's pins."""
import html
import pathlib

# Part: pins from left to right. Net: name, and pins.
XL330 = {
    "parts": {
        "mains adapter|5 V, 4 A": "- +", "F1 fuse|2 A slow": "1 2", "S1 emergency stop|opens when pressed": "1 2",
        "ROBOTIS U2D2 power hub|screw terminals, JST EH": "T- T+ GND VDD DATA", "ROBOTIS XL330|JST EHR-03, pins 1 2 3": "GND VDD DATA",
        "ROBOTIS U2D2|USB to the computer": "GND DATA"},
    "nets": {
        "5 V": "mains+ F1.1", "5 V fused": "F1.2 S1.1", "5 V, off while S1 is pressed": "S1.2 hub.T+",
        "servo 5 V": "hub.VDD XL330.VDD", "data": "hub.DATA XL330.DATA U2D2.DATA", "ground": "mains- hub.T- hub.GND XL330.GND U2D2.GND"},
}
HOBBY = {
    "parts": {
        "mains adapter|5 to 6 V, 5 A": "- +", "F1 fuse|2.5 A slow": "1 2", "S1a emergency stop|first contact": "1 2",
        "hobby servo|": "- + pulse", "C1|1000 µF": "- +", "R4|10 kΩ": "1 2", "R5|10 kΩ": "1 2", "R1|330 Ω": "1 2", "R2|10 kΩ": "1 2",
        "S1b|second contact": "1 2", "R3|1 kΩ": "1 2", "AS5600 board|": "GND DIR VCC OUT", "Arduino Uno or Nano|USB to the computer": "GND D2 D9 A0 A1 5V"},
    "nets": {
        "5 to 6 V": "mains+ F1.1", "fused": "F1.2 S1a.1", "servo supply, off while S1 is pressed": "S1a.2 hobby+ C1+ R4.1",
        "half of the supply": "R4.2 R5.1 Arduino.A1", "pulse at the servo": "R1.2 hobby.pulse", "pulse": "R1.1 R2.1 Arduino.D9",
        "emergency stop": "S1b.1 Arduino.D2", "sensor": "AS5600.OUT R3.1", "sensor at the board": "R3.2 Arduino.A0", "5 V of the board": "AS5600.VCC Arduino.5V",
        "ground": "mains- hobby- C1- R5.2 R2.2 S1b.2 AS5600.GND AS5600.DIR Arduino.GND"},
}
NAMES = {"mains": "mains adapter", "hub": "ROBOTIS U2D2 power hub", "XL330": "ROBOTIS XL330", "U2D2": "ROBOTIS U2D2|", "S1a": "S1a emergency",
         "hobby": "hobby servo", "AS5600": "AS5600 board", "Arduino": "Arduino Uno"}
COLOURS = {"ground": "#111827", "servo": "#b91c1c", "5": "#b91c1c", "fused": "#b91c1c", "half": "#7c3aed", "emergency": "#1d4ed8"}
PIN, GAP, TOP, RAIL = 46, 26, 150, 34


def pins_of(wiring):
    """The pins of each net: a list of (part, pin)."""
    def find(word):
        name, pin = (word[:-1], word[-1]) if word[-1] in "+-" and "." not in word else word.split(".")
        part = next(part for part in wiring["parts"] if part.startswith(NAMES.get(name, name)))
        assert pin in wiring["parts"][part].split(), word
        return part, pin
    return {net: [find(word) for word in words.split()] for net, words in wiring["nets"].items()}


def drawing(title, wiring):
    places, boxes, x = {}, [], 330
    for part, pins in wiring["parts"].items():
        name, _, note = part.partition("|")
        words = pins.split()
        width = max(PIN * len(words), max(10 * len(name), 8.6 * len(note)) + 16)
        boxes.append(f'<rect x="{x:.0f}" y="60" width="{width:.0f}" height="90" rx="6" fill="#f3f4f6" stroke="#374151" stroke-width="2"/>')
        middle = f"{x + width / 2:.0f}"
        boxes.append(f'<text x="{middle}" y="86" text-anchor="middle"><tspan font-weight="bold">{html.escape(name)}</tspan>'
                     f'<tspan x="{middle}" y="106">{html.escape(note)}</tspan></text>')
        places |= {(part, pin): round(x + width * (i + 0.5) / len(words)) for i, pin in enumerate(words)}
        spans = "".join(f'<tspan x="{places[part, pin]}">{pin.replace("-", "−")}</tspan>' for pin in words)
        boxes.append(f'<text y="140" text-anchor="middle">{spans}</text>')
        x += width + GAP
    wires, y = [], TOP + 50
    for net, pins in pins_of(wiring).items():
        colour = next((colour for word, colour in COLOURS.items() if net.startswith(word)), "#b45309")
        at = sorted(places[pin] for pin in pins)
        drops = "".join(f"M{pin_x} {TOP}V{y}" for pin_x in at)
        dots = "".join(f"M{pin_x} {y}h0" for pin_x in at)
        wires.append(f'<path stroke="{colour}" stroke-width="3" fill="none" d="M320 {y}H{at[-1]}{drops}"/>')
        wires.append(f'<path stroke="{colour}" stroke-width="12" stroke-linecap="round" d="{dots}"/>')
        wires.append(f'<text x="312" y="{y + 5}" text-anchor="end">{html.escape(net)}</text>')
        y += RAIL
    width, height = max(1200, x), y + 20
    return (f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height}" width="{width:.0f}" height="{height}" '
            f'font-family="sans-serif" font-size="16" role="img">\n<title>{title}</title>\n<rect width="{width:.0f}" height="{height}" fill="#fff"/>\n'
            f'<text x="20" y="36" font-size="20" font-weight="bold">{title}</text>\n' + "\n".join(wires + boxes) + "\n</svg>\n")


if __name__ == "__main__":
    folder = pathlib.Path(__file__).parent
    (folder / "wiring_xl330.svg").write_text(drawing("Wiring of a plate with an XL330", XL330))
    (folder / "wiring_hobby.svg").write_text(drawing("Wiring of a plate with a hobby servo", HOBBY))

// Four figures that explain the illusion, each with one control. Drawn stronger than it is: touch has a third of the weight.
import { degree } from "./geometry";
import { element } from "./page";

const touch = 1 / 3;
const length = 130,
  foot = { x: 160, y: 195 };

const at = (angle_deg: number, far: number): string =>
  `${(foot.x - far * Math.sin(angle_deg * degree)).toFixed(1)} ${(foot.y - far * Math.cos(angle_deg * degree)).toFixed(1)}`;
const arrow = (kind: string, from: string, to: string): string =>
  `<path class="${kind}" marker-end="url(#tip-${kind})" d="M${from} L${to}"/>`;
const word = (kind: string, place: string, text: string): string =>
  `<text class="${kind}" transform="translate(${place})">${text}</text>`;
const dot = (kind: string, place: string): string => `<circle class="${kind}" r="8" transform="translate(${place})"/>`;
const tips = ["real", "felt", "touch"]
  .map(
    (kind) => `<marker id="tip-${kind}" viewBox="0 0 8 8" refX="6" refY="4" markerWidth="5" markerHeight="5"
  orient="auto"><path class="tip ${kind}" d="M0 0 L8 4 L0 8 Z"/></marker>`,
  )
  .join("");

/** The plate from above, its ridges turned. */
function plate(turned_deg: number): string {
  const lines = [-4, -3, -2, -1, 0, 1, 2, 3, 4].map((i) => {
    const half = Math.sqrt(95 * 95 - 400 * i * i);
    return `<path class="ridge" d="M${160 - half} ${115 + 20 * i} h${2 * half}"/>`;
  });
  return `<defs>${tips}</defs><circle class="disc" cx="160" cy="115" r="100"/><g transform="rotate(${-turned_deg} 160 115)">${lines.join("")}</g>`;
}

/** Where the hand goes of one who keeps what is felt straight ahead: 0 = (1 - touch) hand + touch plate. */
const hand_deg = (plate_deg: number): number => (-touch * plate_deg) / (1 - touch);

const figures: readonly ((value: number) => string)[] = [
  (across) => {
    // skin that is lifted where the ridge is
    const x = 60 + 2 * across,
      skin = Array.from({ length: 41 }, (_, i) => {
        const u = x - 50 + 2.5 * i,
          y = 160 - 26 * Math.exp(-(((u - 160) / 14) ** 2));
        return `${u.toFixed(1)} ${Math.min(160 - 0.06 * Math.max(0, Math.abs(u - x) - 30) ** 2, y).toFixed(1)}`;
      });
    return (
      `<path class="desk" d="M10 164 H310 V190 H10 Z"/><path class="bump" d="M146 164 Q160 116 174 164 Z"/>` +
      `<path class="skin" d="M${skin.join(" L")} L${x + 46} 60 Q${x} 10 ${x - 46} 60 Z"/>` +
      word("touch", "160 212", Math.abs(x - 160) < 50 ? "felt!" : "nothing felt")
    );
  },
  (plate_deg) => {
    const felt_deg = touch * plate_deg;
    return (
      plate(plate_deg) +
      arrow("real", at(0, 0), at(0, length)) +
      arrow("felt", at(0, 0), at(felt_deg, length)) +
      (Math.abs(felt_deg) > 4 ? arrow("touch", at(0, length + 12), at(felt_deg, length + 12)) : "") +
      word("real", at(-13 * Math.sign(plate_deg || 1), 80), "true") +
      word("felt", at(felt_deg + 16 * Math.sign(plate_deg || 1), 80), "felt") +
      word("touch", at(felt_deg / 2, length + 24), "touch")
    );
  },
  (gone) => {
    const far = (length * gone) / 100,
      hand = hand_deg(50);
    return (
      plate(50) +
      arrow("felt", at(0, 0), at(0, far + 1)) +
      arrow("real", at(0, 0), at(hand, far + 1)) +
      dot("felt", at(0, length + 16)) +
      word("felt", at(16, 90), "felt") +
      word("real", at(hand - 15, 90), "true")
    );
  },
  (hand) =>
    plate((-hand * (1 - touch)) / touch) +
    arrow("felt", at(0, 0), at(0, length - 4)) +
    arrow("real", at(0, 0), at(hand, length - 4)) +
    dot("real", at(hand, length + 16)) +
    dot("felt", at(0, length + 16)) +
    word("felt", at(0, length + 32), "glass") +
    (Math.abs(hand) > 8 ? word("real", at(hand + 24 * Math.sign(hand), length + 8), "cylinder") : ""),
];

export function showFigures(): void {
  figures.forEach((draw, i) => {
    const picture = element(`figure-${i + 1}`, SVGSVGElement),
      input = element(`see-${i + 1}`, HTMLInputElement);
    const show = () => {
      picture.innerHTML = draw(Number(input.value));
    };
    input.addEventListener("input", show);
    show();
  });
}

"""Draws the figures of figures.json, a list with name, title and data of each, into NAME.svg. hrt-study contains and runs this script."""
import itertools
import json
import math

import matplotlib
import numpy

matplotlib.use("svg")
matplotlib.rcParams.update({"svg.fonttype": "none", "svg.hashsalt": "hrt-study", "font.size": 10, "axes.grid": True, "axes.axisbelow": True,
                            "grid.color": "#dddddd", "grid.linewidth": 0.6, "legend.fontsize": 8, "axes.titlesize": 10})
import matplotlib.pyplot

REAL, VIRTUAL, PLATE, GREY = "#1b7837", "#b35806", "#08306b", "#555555"
SIDEWAYS, AWAY = "to the right of the mid-line, mm", "away from the participant, mm"


def signed(value):
    return f"{value:g}".replace("-", "−")


def path(directions_deg):
    """Returns positions (right, away) in mm of a path of 100 mm with steps of equal length in the given directions."""
    steps = numpy.radians(directions_deg)
    return numpy.vstack([[0, 0], numpy.cumsum(numpy.column_stack([-numpy.sin(steps), numpy.cos(steps)]), axis=0) * 100 / len(steps)])


def draw_many(axes, xs, ys, color, median_color, style="-", width=0.7, label="median"):
    """Draws a curve for each column of `ys`, and their median."""
    for line in axes.plot(xs, ys, color=color, linewidth=width)[:1]:
        line.set_label("one trial" if label == "median" else None)
    middle = xs if xs.ndim == 1 else numpy.median(xs, axis=1)
    axes.plot(middle, numpy.median(ys, axis=1), style, color=median_color, linewidth=3, label=label)


def draw_ridges(figure, data):
    axes = figure.subplots()
    for angle, color in zip(data["angles"], itertools.cycle(["#b35806", "#f1a340", "#555555", "#67a9cf", "#08306b"])):
        paths = numpy.array([path(directions) for directions in angle["directions_deg"]])
        draw_many(axes, paths[:, :, 0].T, paths[:, :, 1].T, color, color, width=0.4, label=f"plate at {signed(angle['plate_deg'])}°")
    axes.set(xlim=(-35, 35), ylim=(0, 105), aspect="equal", xlabel=SIDEWAYS, ylabel=AWAY)
    axes.legend(loc="upper left", bbox_to_anchor=(1, 1))


def draw_paths(figure, data):
    true, perceived, plate, direction = figure.subplots(4, 1)
    perceived.sharex(true)
    for axes, title, name, colors, style in ((true, "a: true paths (sideways enlarged)", "true_deg", ("#9ecae1", "#a50f15"), "-"),
                                             (perceived, "b: perceived paths (sideways enlarged)", "perceived_deg", ("#bdbdbd", "#00441b"), "--")):
        paths = numpy.array([path(directions) for directions in data[name]])
        draw_many(axes, paths[:, :, 0].T, paths[:, :, 1].T, *colors, style)
        axes.plot(*path([data["real_deg"]])[-1], "o", color=REAL, label="real target")
        axes.plot(*path([data["virtual_deg"]])[-1], "^", color=VIRTUAL, fillstyle="none", label="virtual target")
        axes.set(title=title, ylim=(0, 110), xlabel=SIDEWAYS, ylabel=AWAY)
    if data["bound_deg"] is not None:
        for side, label in ((-1, "bound"), (1, None)):
            plate.axhline(data["virtual_deg"] + side * data["bound_deg"], linestyle=":", color=GREY, label=label)
    if data["sustaining_deg"] is not None:
        plate.axhline(data["sustaining_deg"], linestyle="--", color=VIRTUAL, label="sustains the gap")
    plate.plot(data["plate_deg"], "o-", color=PLATE, markersize=3, label="plate")
    plate.set(title="c: plate orientation in one trial", ylim=(-110, 110), xlabel="model step (0.1 s)", ylabel="plate orientation, °")
    directions = numpy.array(data["direction_deg"]).T
    draw_many(direction, numpy.arange(len(directions)), directions, "#9ecae1", "#a50f15")
    for side, label in ((-1, f"real ± {data['tolerance_deg']}°"), (1, None)):
        direction.axhline(data["real_deg"] + side * data["tolerance_deg"], color=GREY, label=label)
    direction.axhline(data["virtual_deg"], linestyle="--", color=VIRTUAL, label="virtual")
    direction.set(title="d: true direction of motion", ylim=(-15, 15), xlabel="model step (0.1 s)", ylabel="direction, ° (left positive)")
    for axes in (true, perceived, plate, direction):
        axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.16), ncol=4)


def wilson(share, trials, z=1.959964):
    centre, half = share + z * z / (2 * trials), z * numpy.sqrt(share * (1 - share) / trials + z * z / (4 * trials * trials))
    return (centre - half) / (1 + z * z / trials), (centre + half) / (1 + z * z / trials)


def draw_table1(figure, data):
    for axes, condition in zip(figure.subplots(4, 1), data["conditions"]):
        rows = [row for row in data["rows"] if row["group"] == condition["name"]]
        column = lambda name: numpy.array([row[name] for row in rows])
        places, paper, model = numpy.arange(len(rows)), column("paper_percent"), column("percent")
        low, high = wilson(model / 100, column("trials"))
        axes.axhline(condition["limit_percent"], linestyle="--", color=GREY, label="limit")
        axes.errorbar(places - 0.12, paper, [paper - column("paper_low_percent"), column("paper_high_percent") - paper], fmt="o", color=PLATE, label="paper")
        axes.errorbar(places + 0.12, model, [model - 100 * low, 100 * high - model], fmt="s", color=VIRTUAL, label="model")
        axes.set_xticks(places, [f"{signed(row['real_direction_deg'])} / {signed(row['virtual_direction_deg'])}" for row in rows])
        axes.set(title=f"Condition {condition['name'][10:]}: σ_u² = {rows[0]['motor_variance_deg2']:g} (°)², w_T = {rows[0]['tactile_weight']:g}",
                 ylim=(50, 100), xlabel="real / virtual direction, °", ylabel="trials within 1.5°, %")
    axes.legend(loc="upper center", bbox_to_anchor=(0.5, -0.25), ncol=3)


def between(value, digits, unit=""):
    return f"{value['value']:.{digits}f}{unit} ({value['interval'][0]:.{digits}f} to {value['interval'][1]:.{digits}f})".replace("-", "−")


def draw_calibration(figure, data):
    axes = figure.subplot_mosaic([["curve"] * 3, ["slides"] * 3, ["angle", "order", "path"]])
    offsets, shifts = ([point[name] for point in data["curve"]] for name in ("offset_deg", "shift_deg"))
    axes["curve"].fill_between(offsets, *zip(*(point["interval"] for point in data["curve"])), color="#c6dbef", label="95 %")
    axes["curve"].plot(offsets, shifts, color=PLATE, label="curve")
    axes["curve"].set(title=f"Illusion\nw_T = {between(data['tactile_weight'], 3)}, largest gap {between(data['max_gap_deg'], 1, '°')}",
                      xlabel="ridge normal minus motion, °", ylabel="shift of the perceived direction, °")
    axes["curve"].legend()
    looks = {"used": ("slide", "o", VIRTUAL), "outlying": ("outlier", "x", "#d7191c"), "along_ridges": ("along ridges", ".", "#999999")}
    for verdict, (label, marker, color) in looks.items():
        slides = [slide for slide in data["slides"] if slide["verdict"] == verdict]
        column = lambda name: numpy.array([slide[name] for slide in slides], dtype=float)
        if verdict == "used":
            axes["slides"].plot(column("plate_deg"), column("fitted_deg"), "v", color=PLATE, markersize=5, label="fit")
            residuals = numpy.array([slide["residuals_deg"] for slide in slides])
        axes["slides"].plot(column("plate_deg"), column("direction_deg"), marker, color=color, markersize=5, label=label)
        if verdict != "along_ridges":
            for name, x in (("angle", "plate_deg"), ("order", "trial")):
                axes[name].plot(column(x), column("direction_deg") - column("fitted_deg"), marker, color=color, markersize=4)
    axes["slides"].set(title=f"Directions of {len(data['slides'])} slides\nbias {between(data['bias_deg'], 2, '°')}, habit {between(data['habit_deg'], 2, '°')}",
                       xlabel="plate orientation (normal of the ridges) minus goal, °", ylabel="direction minus goal, °")
    axes["slides"].legend()
    parts, errors = numpy.arange(1, residuals.shape[1] + 1), 1.96 * residuals.std(axis=0) / len(residuals) ** 0.5
    axes["path"].errorbar(parts, residuals.mean(axis=0), errors, fmt="o", color=VIRTUAL)
    for name, title, label in (("angle", "Residuals over the angle", "plate, °"), ("order", "over the order", "trial"), ("path", "along the path", "part of the path")):
        p = data["lack_of_fit"][f"{name}_p"]
        axes[name].axhline(0, color=PLATE, linewidth=1.5)
        axes[name].set(title=f"{title}\np = {p:.3f}" + (": a pattern" if p < data["min_fit_p"] else ""), xlabel=label)
    axes["angle"].set_ylabel("slide minus fit, °")


def draw_trace(figure, data):
    column = lambda name: numpy.array([row[name] for row in data["rows"]], dtype=float)
    for axes, state in itertools.zip_longest(figure.subplots(-(-len(data["states"]) // 4), 4).flat, data["states"]):
        if state is None:
            axes.remove()
            continue
        mean, sd = column(state), column(state + "_sd")
        axes.fill_between(column("time_s"), mean - 2 * sd, mean + 2 * sd, color="#d5e2f0")
        axes.plot(column("time_s"), mean, color=PLATE)
        axes.set_title(state.replace("_", " "))


PLATE_MM, START_MM, FRAMES_S = 75, 50, 25


def animation(opening, values):
    """Returns an SVG element that animates an attribute through these values and pauses at the last one for 1.2 s."""
    total_s = len(values) / FRAMES_S + 1.2
    times = "".join(f"{i / FRAMES_S / total_s:.4f};" for i in range(len(values)))
    return f'{opening} dur="{total_s:.2f}s" repeatCount="indefinite" values="{";".join(values)};{values[-1]}" keyTimes="{times}1"/>'


def moving(places, line, dot):
    """Returns a path that grows over time, with a dot at its end."""
    done_mm = list(itertools.accumulate([0.0, *(math.dist(a, b) for a, b in zip(places, places[1:]))]))
    xs, ys = ([f"{place[i]:.1f}" for place in places] for i in range(2))
    animate = lambda name, values: animation(f'<animate attributeName="{name}"', values)
    return (f'<polyline fill="none" stroke-width="1.4" {line} stroke-dasharray="{done_mm[-1]:.1f} 999" points="'
            + "".join(f"{x},{y} " for x, y in zip(xs, ys)) + '">' + animate("stroke-dashoffset", [f"{done_mm[-1] - done:.1f}" for done in done_mm])
            + f'</polyline>\n<circle r="3.2" {dot}>' + animate("cx", xs) + animate("cy", ys) + "</circle>\n")


def moving_picture(data):
    """Returns the animation of a reach from above, which begins 0.25 s before the motion: plate and ridges, true and perceived path."""
    place = lambda point: (point[0], START_MM - point[1])  # SVG coordinates: right, and down towards the person
    target = lambda deg: place((-data["distance_mm"] * math.sin(math.radians(deg)), data["distance_mm"] * math.cos(math.radians(deg))))
    times = [row["time_s"] for row in data["rows"]]
    first_s = max(times[0], next(row["time_s"] for row in data["rows"] if math.hypot(row["finger_right_mm"], row["finger_away_mm"]) > 1) - 0.25)
    frames = [data["rows"][i] for i in numpy.searchsorted(times, first_s + numpy.arange(int((times[-1] - first_s) * FRAMES_S) + 1) / FRAMES_S)]
    finger, felt = ([place((row[f"{name}_right_mm"], row[f"{name}_away_mm"])) for row in frames] for name in ("finger", "felt"))
    real, virtual = target(data["real_deg"]), target(data["virtual_deg"])
    halves = {across: math.sqrt(PLATE_MM**2 - across**2) for across in range(5 - PLATE_MM, PLATE_MM, 10)}
    circle = lambda at, look: f'<circle cx="{at[0]:.1f}" cy="{at[1]:.1f}" r="6" {look}/>\n'
    label = lambda x, y, anchor, color, text: f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}" fill="{color}">{text}</text>\n'
    side, outside, inside = (-9, "end", "start") if real[0] < virtual[0] else (9, "start", "end")
    return ('<svg xmlns="http://www.w3.org/2000/svg" viewBox="-105 -82 210 174" width="630" height="522" font-family="sans-serif" font-size="7">\n'
            "<title>A simulated reach from above: the turning plate, the path of the finger and the perceived path, the real and the virtual target</title>\n"
            '<rect x="-105" y="-82" width="210" height="174" fill="#ffffff"/>\n<circle r="75" fill="#eef1f5" stroke="#8794a3"/>\n'
            '<g stroke="#b9c4d0" stroke-width="1.1">'
            + animation('<animateTransform attributeName="transform" type="rotate"', [f"{-row['plate_deg']:.1f}" for row in frames])
            + '<path d="' + "".join(f"M{-half:.1f} {across:.1f}h{2 * half:.1f}" for across, half in halves.items()) + '"/></g>\n'
            + circle(real, 'fill="#8fb0d6" stroke="#08306b" stroke-width="1.4"')
            + circle(virtual, 'fill="none" stroke="#c45a00" stroke-width="1.4" stroke-dasharray="3 2"')
            + moving(felt, 'stroke="#c45a00" stroke-opacity="0.75"', 'fill="none" stroke="#c45a00" stroke-width="1.2"')
            + moving(finger, 'stroke="#08306b"', 'fill="#08306b" stroke="#ffffff" stroke-width="0.6"')
            + label(real[0] + side, real[1], outside, "#08306b", "real target")
            + label(virtual[0] - side, virtual[1], inside, "#c45a00", "virtual target")
            + label(0, 85, "middle", "#56616e", "simulated: where the finger is (blue), where it is felt (orange)") + "</svg>\n")


DRAWINGS = {"fig1c": (draw_ridges, 640, 560), "table1": (draw_table1, 560, 1160), "calibration": (draw_calibration, 640, 1000), "trace": (draw_trace, 1200, 900)}

with open("figures.json", encoding="utf-8") as file:
    figures = json.load(file)
for given in figures:
    if given["name"] == "reach":
        with open("reach.svg", "w", encoding="utf-8") as file:
            file.write(moving_picture(given["data"]))
        continue
    draw, width_px, height_px = DRAWINGS.get(given["name"], (draw_paths, 560, 1600))
    figure = matplotlib.pyplot.figure(figsize=(width_px / 72, height_px / 72), constrained_layout=True)
    figure.suptitle(given["title"] + " (simulation)", fontsize=11)
    draw(figure, given["data"])
    figure.savefig(given["name"] + ".svg", metadata={"Date": None})
    matplotlib.pyplot.close(figure)

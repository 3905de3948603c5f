#!/usr/bin/env python3
"""Looks for cliffs: pictures whose time jumps between neighbouring sizes or numbers of samples.

    tests/bench/cliffs.py build/release/isomotion [--scenes 100] [--seed 1] [--gallery] [--only WORD]
                          [--sizes 20] [--largest 1024] [--samples 1,4,16,64] [--csv FILE] [--svg FILE]

Draws random scenes of five classes (kinks, poles, sums, glass, several surfaces), each in a look, and
with --gallery the first frames of every animation, at sizes from 64 pixels on that rise by equal factors.
Two frames are drawn of each, and the second one counts, as the first compiles. Counts are exact and
times are noisy, so both are told: a point is a cliff if its evaluations a pixel, or what its dearest
pixel takes, are more than twice what the geometric mean of its neighbours says; or if its seconds are
more than three times that. A scene is dear if its evaluations a pixel exceed ten times its class's
median. Ends with 1 if any is a cliff or dear.
"""
import argparse
import csv
import json
import math
import os
import random
import statistics
import subprocess
import sys
import tempfile
from pathlib import Path

FIELDS = ["scene", "class", "size", "samples", "seconds", "evaluations", "most", "undecided"]
LOOKS = ["", "studio", "clay", "night", "chrome"]


def ball(draw, reach=0.6):
    x, y, z = (draw.uniform(-reach, reach) for _ in range(3))
    return f"sqrt((x - {x:.3f})^2 + (y - {y:.3f})^2 + (z - {z:.3f})^2) - {draw.uniform(0.3, 0.7):.3f}"


def kinks(draw):
    kind = draw.randrange(4)
    if kind == 0:
        m, n = draw.choice([0.4, 0.67, 0.9, 1.3, 3]), draw.choice([0.5, 0.8, 1.2, 2.5])
        return f"(abs(x)^{m} + abs(y)^{m})^{n / m:.3f} + abs(z)^{n} - 1"
    if kind == 1:
        return f"max({ball(draw)}, {draw.uniform(-0.2, 0.2):.3f} - z, abs(x) - {draw.uniform(0.2, 0.6):.3f})"
    if kind == 2:
        return f"abs(abs(x) - {draw.uniform(0.2, 0.5):.3f}) + abs(y) + abs(z*y) - {draw.uniform(0.3, 0.8):.3f}"
    return f"min({ball(draw)}, max({ball(draw)}, -({ball(draw)})))"


def poles(draw):
    return draw.choice([
        f"y - {draw.uniform(0.2, 0.6):.3f}*x*tan({draw.uniform(2, 5):.3f}*z)",
        f"1/(x^2 + y^2 + {draw.uniform(0.01, 0.2):.3f}) + 1/z - {draw.uniform(2, 6):.3f}",
        f"z - {draw.uniform(0.02, 0.2):.3f}/(x*y)",
    ])


def sums(draw):
    terms = []
    for _ in range(draw.randrange(4, 12)):
        x, y, z = (draw.uniform(-0.7, 0.7) for _ in range(3))
        terms.append(f"exp(-{draw.uniform(6, 30):.2f}*((x - {x:.3f})^2 + (y - {y:.3f})^2 + (z - {z:.3f})^2))")
    return f"{draw.uniform(0.2, 0.5):.3f} - (" + " + ".join(terms) + ")"


def surface(formula, glass):
    text = f"formula = '''{formula}'''\nbounds = {{ sphere = 1.6 }}\n"
    material = "transmission = 1\nior = 1.4\nabsorption = [0.3, 0.1, 0.2]\n" if glass else ""
    return text, material


def scenes(count, seed):
    draw = random.Random(seed)
    classes = {"kinks": kinks, "poles": poles, "sums": sums}
    for k in range(count):
        kind = ["kinks", "poles", "sums", "glass", "several"][k % 5]
        look = draw.choice(LOOKS)
        lines = []
        lines.append("[time]\nframes = 2\n[camera]\nazimuth = '20 + 0.01*t'\nelevation = 25")
        if kind == "several":
            for name in ("a", "b", "c")[:draw.randrange(2, 4)]:
                make = draw.choice([kinks, sums, ball])
                text, material = surface(make(draw), draw.random() < 0.3)
                lines.append(f'[[surfaces]]\nname = "{name}"\n{text}')
                if material:
                    lines.append(f"[surfaces.material]\n{material}")
        else:
            make = classes.get(kind) or draw.choice([kinks, sums, ball])
            text, material = surface(make(draw), kind == "glass")
            lines.append(f"[surface]\n{text}")
            if material:
                lines.append(f"[material]\n{material}")
        if look and not any("transmission" in line for line in lines):
            lines.insert(0, f'look = "{look}"')
        yield f"{kind} {seed}.{k} {look}".strip(), kind, "\n".join(lines) + "\n"


def measure(program, scene, frames, size, samples):
    """Of the second of two frames: seconds, evaluations a pixel and sample, most of a pixel, undecided."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run(
            [program, "render", scene, "--frames", frames, "--size", f"{size}x{size}", "--audit", "off",
             "--set", f"output.samples={samples}", "--quiet", "-o", f"{folder}/f.####.png"],
            text=True, capture_output=True)
        records = sorted(Path(folder).glob("f.manifest/[0-9]*.json"))
        if done.returncode != 0 or len(records) < 2:
            return done.stderr.strip().splitlines()[:1] or ["no picture"]
        kept = json.loads(records[-1].read_text())
        rays = sum(kept["rays"].values())
        # A second frame that shows the same is a copy, which takes no time.
        seconds = kept["drawing seconds"] or json.loads(records[0].read_text())["drawing seconds"]
        return (seconds, sum(kept["evaluations by kind"].values()) / rays,
                max(kept["most of a pixel"].values()), sum(kept["rays undecided"].values()))


def of_neighbours(row, beside, value):
    """What the neighbours of a point say that its value is."""
    # A floor keeps what is next to nothing from being compared.
    return math.exp(statistics.fmean(math.log(max(value(other), 1e-9)) for other in beside)) if beside else None


def cliffs(rows):
    """The points that are more than their neighbours in size say."""
    found = []
    lines = {}
    for row in rows:
        lines.setdefault((row["scene"], row["samples"]), []).append(row)
    seconds_a_pixel = lambda row: (row["seconds"] + 0.05) / row["size"] ** 2
    tests = [("evaluations", lambda row: row["evaluations"] + 0.5, 2),
             ("most of a pixel", lambda row: row["most"] + 50, 2),
             ("seconds", seconds_a_pixel, 3)]
    for line in lines.values():
        line.sort(key=lambda row: row["size"])
        for k, row in enumerate(line):
            beside = [line[j] for j in (k - 1, k + 1) if 0 <= j < len(line)]
            for name, value, factor in tests:
                expected = of_neighbours(row, beside, value)
                if expected and value(row) > factor * expected:
                    found.append((row, name, value(row) / expected))
    return found


def dear(rows):
    """The scenes whose evaluations exceed ten times the median of their class."""
    means = {}
    for row in rows:
        means.setdefault((row["class"], row["scene"]), []).append(row["evaluations"])
    means = {key: statistics.fmean(all) for key, all in means.items()}
    found = []
    for (kind, scene), mean in means.items():
        median = statistics.median(value for (other, _), value in means.items() if other == kind)
        if mean > 10 * median:
            found.append((scene, mean, median))
    return found


def plot(rows, file):
    """Seconds over pixels, a line a scene, both on logarithmic axes."""
    width, height, margin = 640, 400, 60
    lines = {}
    for row in rows:
        lines.setdefault((row["scene"], row["samples"]), []).append(row)
    x_of, y_of = (lambda row: math.log10(row["size"])), (lambda row: math.log10(max(row["seconds"], 1e-3)))
    xs, ys = [x_of(row) for row in rows], [y_of(row) for row in rows]
    low_x, high_x, low_y, high_y = min(xs), max(xs), math.floor(min(ys)), math.ceil(max(ys))
    place_x = lambda v: margin + (v - low_x) / max(high_x - low_x, 1e-9) * (width - 2 * margin)
    place_y = lambda v: height - margin - (v - low_y) / max(high_y - low_y, 1e-9) * (height - 2 * margin)
    text = [f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width} {height}" font-family="sans-serif" '
            'font-size="12">', f'<rect width="{width}" height="{height}" fill="white"/>']
    for power in range(low_y, high_y + 1):
        y = place_y(power)
        text.append(f'<line x1="{margin}" x2="{width - margin}" y1="{y:.1f}" y2="{y:.1f}" stroke="#ddd"/>'
                    f'<text x="{margin - 6}" y="{y + 4:.1f}" text-anchor="end">{10.0 ** power:g} s</text>')
    for size in (64, 128, 256, 512, 1024):
        if low_x <= math.log10(size) <= high_x + 1e-9:
            text.append(f'<text x="{place_x(math.log10(size)):.1f}" y="{height - margin + 18}" '
                        f'text-anchor="middle">{size}</text>')
    for index, ((scene, _), line) in enumerate(lines.items()):
        points = " ".join(f"{place_x(x_of(row)):.1f},{place_y(y_of(row)):.1f}"
                          for row in sorted(line, key=lambda row: row["size"]))
        text.append(f'<polyline points="{points}" fill="none" stroke="hsl({37 * index % 360},60%,45%)">'
                    f'<title>{scene}</title></polyline>')
    text.append(f'<text x="{width / 2}" y="{height - 8}" text-anchor="middle">pixels along a side</text></svg>')
    Path(file).write_text("\n".join(text) + "\n")


def animations(program, only):
    for line in subprocess.run([program, "list", "animations"], text=True, capture_output=True).stdout.splitlines():
        name = line.split()[0] if line.strip() else ""
        if name and only in name:
            yield name


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--scenes", type=int, default=100)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--gallery", action="store_true")
    parser.add_argument("--only", default="")
    parser.add_argument("--sizes", type=int, default=20)
    parser.add_argument("--largest", type=int, default=1024)
    parser.add_argument("--samples", default="1,4,16,64")
    parser.add_argument("--csv")
    parser.add_argument("--svg")
    asked = parser.parse_args()
    steps = max(asked.sizes - 1, 1)
    sizes = sorted({round(64 * (asked.largest / 64) ** (k / steps)) for k in range(asked.sizes)})
    samples = [int(number) for number in asked.samples.split(",")]
    with tempfile.TemporaryDirectory() as folder:
        subjects = []
        for name, kind, text in scenes(asked.scenes, asked.seed):
            if asked.only in name:
                file = Path(folder) / (name.replace(" ", "_") + ".toml")
                file.write_text(text)
                subjects.append((name, kind, str(file), "1-2"))
        if asked.gallery:
            subjects += [(name, "gallery", name, "1-2") for name in animations(asked.program, asked.only)]
        rows, failed = [], 0
        for name, kind, scene, frames in subjects:
            for number in samples:
                for size in sizes:
                    found = measure(asked.program, scene, frames, size, number)
                    if isinstance(found, list):
                        print(f"{name}, {size}, {number} samples: {found[0]}")
                        failed += 1
                        break
                    rows.append(dict(zip(FIELDS, (name, kind, size, number, *found))))
            print(f"{name}: {len(rows)} pictures", file=sys.stderr)
    if asked.csv:
        with open(asked.csv, "w", newline="") as file:
            writer = csv.DictWriter(file, FIELDS)
            writer.writeheader()
            writer.writerows(rows)
    if asked.svg and rows:
        plot(rows, asked.svg)
    steep, costly = cliffs(rows), dear(rows)
    for row, name, factor in steep:
        print(f"cliff: {row['scene']}, {row['size']} pixels, {row['samples']} samples: {name} "
              f"{factor:.1f} times what its neighbours say")
    for scene, mean, median in costly:
        print(f"dear: {scene}: {mean:.1f} evaluations a ray, {median:.1f} in the median of its class")
    undecided = sum(row["undecided"] for row in rows)
    print(f"{len(rows)} pictures: {len(steep)} cliffs, {len(costly)} dear scenes, {undecided} rays undecided, "
          f"{failed} not drawn")
    return 1 if steep or costly or failed or not rows else 0


if __name__ == "__main__":
    sys.exit(main())

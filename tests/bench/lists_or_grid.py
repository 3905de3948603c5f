#!/usr/bin/env python3
"""Draws soft balls of some sizes, from few to many, by the lists of beams and by what a scene gets otherwise.

    tests/bench/lists_or_grid.py build/release/isomotion [--counts 100,200,400,800] [--sizes 64,128,256,512]
                                 [--widths 0.25,0.35,0.5,0.8] [--kinds gaussians,cones] [--rounds 3]

Prints a table of Markdown: milliseconds of a frame by lists (`isolation.beam = true`) over those by default,
the least of each in turn; in italics where the default is lists, too, so that the ratio tells how noisy the
machine is. A width is that of a ball's support, for balls in a box of 2.4 across. Cones have kinks, and rays
go by bounds. The rule that this measures is in src/shader/finding_elements.cpp.
"""
import argparse
import re
import subprocess
import sys
import tempfile
from pathlib import Path

SQUARED = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)"
KINDS = {
    "gaussians": (f"sum(p, exp(-{{a}}*{SQUARED})) - {{level}}", "a"),
    "cones": (f"sum(p, max(0, 1 - {SQUARED}/{{width}}^2)) - 0.5", "width"),
}


def write_scene(folder, kind, count, width):
    a = 8 / width ** 2  # the terms fade to 3e-4 at the width
    formula = KINDS[kind][0].format(a=a, width=width, level=0.45)
    scene = folder / f"{kind}{count}_{width}.toml"
    scene.write_text(f"""[time]
fps = 30
frames = 60
[surface]
formula = "{formula}"
bounds = {{ box = [[-1.75, -1.75, -1.75], [1.75, 1.75, 1.75]] }}
[arrays.p]
count = {count}
cx = "1.2*(2*random(i, 0) - 1) + 0.1*sin(t)"
cy = "1.2*(2*random(i, 1) - 1)"
cz = "1.2*(2*random(i, 2) - 1)"
""")
    return scene


def drawn(program, scene, size, folder, *more):
    """Milliseconds of a frame, and the evaluations a ray that tell how it was drawn."""
    done = subprocess.run([program, "render", scene, "--size", f"{size}x{size}", "--frames", "10-50x20", *more,
                           "-o", str(folder / "frame_####.png")], text=True, capture_output=True)
    told = re.search(r"\(([\d.]+) ms each, ([\d.]+) evaluations", done.stdout)
    if done.returncode != 0 or not told:
        sys.exit(f"{scene} was not drawn:\n{done.stdout}{done.stderr}")
    return float(told[1]), told[2]


def numbers(kind):
    return lambda text: [kind(item) for item in text.split(",")]


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--counts", type=numbers(int), default="100,200,400,800")
    parser.add_argument("--sizes", type=numbers(int), default="64,128,256,512")
    parser.add_argument("--widths", type=numbers(float), default="0.25,0.35,0.5,0.8")
    parser.add_argument("--kinds", type=numbers(str), default="gaussians,cones")
    parser.add_argument("--rounds", type=int, default=3)
    given = parser.parse_args()
    unknown = [kind for kind in given.kinds if kind not in KINDS]
    if unknown or given.rounds < 1:
        parser.error(f"--kinds are {', '.join(KINDS)}; --rounds is 1 or more")
    print("| kind | width | elements | " + " | ".join(f"{size}x{size}" for size in given.sizes) + " |")
    print("|---|--:|--:|" + "--:|" * len(given.sizes))
    for kind in given.kinds:
        for width in given.widths:
            for count in given.counts:
                cells = []
                for size in given.sizes:
                    with tempfile.TemporaryDirectory() as folder:
                        folder = Path(folder)
                        scene = write_scene(folder, kind, count, width)
                        both = [(drawn(given.program, scene, size, folder),
                                 drawn(given.program, scene, size, folder, "--set", "isolation.beam=true"))
                                for _ in range(given.rounds)]
                    default, lists = min(b[0] for b in both), min(b[1] for b in both)
                    ratio = f"{lists[0] / default[0]:.2f}"
                    cells.append(f"*{ratio}*" if default[1] == lists[1] else ratio)
                print(f"| {kind} | {width:g} | {count} | " + " | ".join(cells) + " |", flush=True)


if __name__ == "__main__":
    main()

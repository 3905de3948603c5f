#!/usr/bin/env python3
"""Draws sums over more and more elements, and the least of them, which shrink so that the picture keeps its grain.

    tests/bench/many_elements.py build/release/isomotion [--counts 75,1000,10000,100000] [--size 512]
                                 [--frames 6] [--kinds gaussians,wyvill,anisotropic,balls]

Prints a table: the mean time of a frame, sorting the elements and compiling once included, and that
over the time of the fewest elements; evaluations a ray; the most memory so far. Ratios within one run
compare; times are the machine's.
"""
import argparse
import random
import re
import resource
import subprocess
import sys
import tempfile
from pathlib import Path

DISTANCE = "((x-cx)^2 + (y-cy)^2 + (z-cz)^2)"
KINDS = {
    "gaussians": f"level - sum(p, exp(-a*{DISTANCE}))",
    "wyvill": f"level - sum(p, max(0, 1 - {DISTANCE}/h^2)^3)",
    "anisotropic": "level - sum(p, w*max(0, 1 - (gxx*(x-cx) + gxy*(y-cy) + gxz*(z-cz))^2"
                   " - (gxy*(x-cx) + gyy*(y-cy) + gyz*(z-cz))^2"
                   " - (gxz*(x-cx) + gyz*(y-cy) + gzz*(z-cz))^2)^3)",
    "balls": f"least(p, sqrt({DISTANCE}) - level*h)",
}


def places(count):
    """Places spread evenly in the ball of radius 1, by a seed of their own."""
    draw = random.Random(3)
    made = []
    while len(made) < count:
        place = [draw.uniform(-1, 1) for _ in range(3)]
        if sum(c * c for c in place) <= 1:
            made.append(place)
    return made


def write_scene(folder, kind, count, frames):
    grain = (75 / count) ** (1 / 3)
    draw = random.Random(5)
    width = 0.26 * grain
    names, rows = ["cx", "cy", "cz"], places(count)
    if kind == "anisotropic":
        names += ["w", "gxx", "gxy", "gxz", "gyy", "gyz", "gzz"]
        for row in rows:
            vary = [draw.uniform(-1, 1) for _ in range(7)]
            row += [1 + 0.3 * vary[0]]
            row += [(1 + 0.4 * v if k in (0, 3, 5) else 0.25 * v) / width for k, v in enumerate(vary[1:])]
    (folder / f"{kind}{count}.csv").write_text(
        "\n".join([",".join(names)] + [",".join(f"{v:.7g}" for v in row) for row in rows]) + "\n")
    parameters = ["level = 0.35"]
    if kind == "gaussians":
        parameters.append(f"a = {62 / grain ** 2:.7g}")
    if kind in ("wyvill", "balls"):
        parameters.append(f"h = {width:.7g}")
    scene = folder / f"{kind}{count}.toml"
    scene.write_text(f"""title = "{count} {kind}"
[time]
frames = {frames}
[surface]
formula = "{KINDS[kind]}"
bounds = {{ sphere = 1.2 }}
[parameters]
{chr(10).join(parameters)}
[arrays.p]
file = "{kind}{count}.csv"
[camera]
position = ["2.5 + 0.001*t", 1.6, 1.4] # each frame anew
""")
    return scene


def drawn(program, scene, size, folder):
    """Milliseconds a frame and evaluations a ray, as render tells them."""
    command = [program, "render", str(scene), "--size", f"{size}x{size}", "--audit", "off",
               "-o", str(folder / "drawn.####.png")]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    told = re.search(r"drawn \d+ in \S+ s \((\S+) ms each, (\S+) evaluations a ray\)",
                     done.stdout + done.stderr)
    if not told:
        sys.exit(done.stdout + done.stderr)
    return float(told[1]), float(told[2])


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--counts", default="75,1000,10000,100000")
    parser.add_argument("--kinds", default=",".join(KINDS))
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--frames", type=int, default=6)
    arguments = parser.parse_args()
    print("| kernel | elements | ms a frame | times | evaluations a ray | MB |\n|---|--:|--:|--:|--:|--:|")
    with tempfile.TemporaryDirectory() as name:
        folder = Path(name)
        for kind in arguments.kinds.split(","):
            fewest = None
            for count in map(int, arguments.counts.split(",")):
                scene = write_scene(folder, kind, count, arguments.frames)
                ms, evaluations = drawn(arguments.program, scene, arguments.size, folder)
                fewest = fewest or ms
                peak = resource.getrusage(resource.RUSAGE_CHILDREN).ru_maxrss / 1024
                print(f"| {kind} | {count} | {ms:.0f} | {ms / fewest:.1f} | {evaluations} | {peak:.0f} |",
                      flush=True)


if __name__ == "__main__":
    main()

#!/usr/bin/env python3
"""Times isomotion's methods beside POV-Ray (isosurface) and jsurf-alggeo on the same pictures.

    tests/bench/peers.py -o FOLDER [--size 512] [--repeat 5] [--methods a,b] [--pictures] [NAME...]

The objects are examples of jsurf-alggeo, with its camera and its clipping ball, and the body of 75
blobs (POV-Ray only). What is not installed is left out, and says so. Writes peers.csv, peers.md
and, where gnuplot is, peers.svg; with --pictures what each program drew.

Whole processes are timed, all programs in turn, round by round; a frame is what a program reports
of its drawing alone (isomotion: the median of `isomotion accuracy`, POV-Ray: its trace time).

isomotion draws with each method; with those that take steps, at the largest of some at which truth
finds the fewest wrong pixels. POV-Ray misses parts where max_gradient is too small and slows down where it is large: it is
doubled from 1 until, at 128 x 128, no pixel off a silhouette differs from the most accurate picture of
isomotion; if that does not happen by 2^36 or before a picture takes 30 s of all processors, the
value with the fewest such pixels is taken. The table tells how many differ at full size.
"""
import argparse
import csv
import dataclasses
import math
import pathlib
import re
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
import tomllib

import povray
from compare_jsurf import EXAMPLES, differences, hits, jsurf_command, on_magenta, scene_of

ROOT = pathlib.Path(__file__).resolve().parents[2]
NAMES = ["record_cayleycubic", "record_kummerquartic", "record_barthsextic", "record_labsseptic",
         "record_endrass", "record_chmutovoktic", "blobby75"]
PEERS = {"povray": "povray", "jsurf-alggeo": "jsurf-alggeo default-jre-headless"}
STEPPING = ["marching", "amp-sign", "amp-taylor"]
HALVINGS = 7            # of their step, at most
DOUBLINGS = 36          # of POV-Ray's max_gradient, at most
SEARCH_SIZE = 128
PATIENCE = 600          # seconds that a picture may take
SEARCH_PATIENCE = 30    # and, of all processors, one of the search
WORKED = re.compile(r"with ([\d.]+) CPU-seconds total")


@dataclasses.dataclass
class Object:
    name: str
    step: float              # isomotion's coarsest
    radius: float            # of the ball that cuts it
    back: list               # axes of the camera
    up: list
    body: str                # POV-Ray's function
    example: pathlib.Path | None

    def scene(self, size):
        """isomotion's scene; its picture is 2 radii high from the first pixel's middle to the last one's."""
        if self.example:
            return scene_of(self.example, size)
        return "\n".join(
            ["[surface]", 'use = "blinn_blobby"', "[parameters]", f"s = {self.spread!r}",
             "[camera]", 'projection = "orthographic"', f"height = {2 * self.radius!r}",
             f"zoom = {(size - 1) / size!r}",
             f"position = {[3 * self.radius * c for c in self.back]}", f"up = {self.up}",
             "[output]", 'background = "transparent"', ""])

    def pov(self, size, max_gradient):
        pixel = 2 * self.radius / (size - 1)
        return povray.scene(self.body, self.radius, self.back, self.up, pixel * size,
                            0.1 * pixel, max_gradient)


def of_jsurf(name):
    example = EXAMPLES / f"{name}.jsurf"
    if not example.exists():
        return None
    keys = dict(line.split("=", 1) for line in example.read_text().splitlines()
                if "=" in line and not line.startswith("#"))
    m = [float(v) for v in keys["rotation_matrix"].split()]
    radius = 10 ** float(keys["scale_factor"])
    constants = {k[-1]: float(v) for k, v in keys.items() if k.startswith("surface_parameter_")}
    return Object(name, radius / 100, radius, m[2::4][:3], m[1::4][:3],
                  povray.function(keys["surface_equation"], constants), example)


def blobby75(isomotion):
    """The blobs as the animation's poster has them, seen from the axis x."""
    surface = tomllib.loads((ROOT / "animations/surfaces/blinn_blobby.toml").read_text())
    animation = tomllib.loads((ROOT / "animations/blobby75.toml").read_text())
    shown = subprocess.run([isomotion, "show", ROOT / "animations/blobby75.toml", "--frame",
                            str(animation["output"]["poster"])], check=True, capture_output=True,
                           text=True).stdout
    spread = float(re.search(r"^\s+s\s+(\S+)", shown, re.M)[1])
    a, size, level = (surface["parameters"][k]["default"] for k in "aRT")
    blobs = surface["arrays"]["blobs"]
    elements = [{"cx": spread * x, "cy": spread * y, "cz": spread * z}
                for x, y, z in zip(blobs["ux"], blobs["uy"], blobs["uz"])]
    radius = spread + max(0.6, math.sqrt(size**2 + math.log(75 / level) / a))
    body = povray.sum_of("exp(-a*((x-cx)^2 + (y-cy)^2 + (z-cz)^2 - R^2))", {"a": a, "R": size},
                         elements) + f" - {level!r}"
    object = Object("blobby75", surface["isolation"]["step"], radius, [1.0, 0.0, 0.0],
                    [0.0, 0.0, 1.0], body, None)
    object.spread = spread
    return object


def seconds(command):
    """Wall time of a process and what it wrote; None if it fails or takes too long."""
    begin = time.monotonic()
    try:
        done = subprocess.run(command, capture_output=True, text=True, timeout=PATIENCE)
    except subprocess.TimeoutExpired:
        return None, f"took more than {PATIENCE} s"
    took = time.monotonic() - begin
    return (took if done.returncode == 0 else None), done.stdout + done.stderr


def methods_of(isomotion):
    listed = subprocess.run([isomotion, "list", "methods"], check=True, capture_output=True,
                            text=True).stdout
    return [line.split()[0] for line in listed.splitlines() if line.strip()]


@dataclasses.dataclass
class Entry:
    program: str
    setting: str
    command: list
    picture: pathlib.Path
    frame_ms: float | None = None
    wrong_ppm: float | None = None
    times: list = dataclasses.field(default_factory=list)
    failed: str = ""


def ours(object, method, arguments, folder, scene):
    """The method at the largest step with the fewest wrong pixels, and its frame."""
    steps = [object.step / 2**k for k in range(HALVINGS if method in STEPPING else 1)]
    report = folder / f"{object.name}-{method}"
    took, text = seconds([arguments.isomotion, "accuracy", scene, "--size",
                          f"{arguments.size}x{arguments.size}", "--methods", method, "--steps",
                          ",".join(map(repr, steps)), "--repeat", str(arguments.repeat), "--quiet",
                          "-o", report])
    picture = folder / f"{object.name}-{method}.png"
    if took is None:
        return Entry("isomotion", method, [], picture, failed=text.strip().splitlines()[-1])
    rows = list(csv.DictReader((report / "accuracy.csv").open()))
    best = min(rows, key=lambda row: (float(row["wrong_ppm"]), -float(row["step"])))
    command = [arguments.isomotion, "render", scene, "--size", f"{arguments.size}x{arguments.size}",
               "--method", method, "--step", best["step"], "--quiet", "-o", picture]
    step = f", step {float(best['step']):.3g}" if method in STEPPING else ""
    return Entry("isomotion", method + step, command, picture,
                 float(best["ms"]), float(best["wrong_ppm"]))


def max_gradient(object, most_accurate, folder):
    """See the head of this file; the setting and the pixels off silhouettes that it leaves."""
    scene, picture = folder / "search.toml", folder / "search.png"
    scene.write_text(object.scene(SEARCH_SIZE))
    command = [str(part) for part in most_accurate.command]
    command[command.index("--size") + 1] = f"{SEARCH_SIZE}x{SEARCH_SIZE}"
    command[2], command[-1] = str(scene), str(picture)
    subprocess.run(command, check=True)
    right, best = hits(picture), None
    for doubling in range(DOUBLINGS + 1):
        pov, drawn = folder / "search.pov", folder / "search-pov.png"
        pov.write_text(object.pov(SEARCH_SIZE, 2.0**doubling))
        took, text = seconds(povray.command(pov, SEARCH_SIZE, drawn))
        if took is None:
            if best is None:
                raise RuntimeError("povray: " + text.strip()[-300:])
            break
        differ, lonely = differences(right, hits(drawn))
        if best is None or (lonely, differ) < best[:2]:
            best = (lonely, differ, 2.0**doubling)
        # The processor's time counts: what else the machine does must not end the search.
        work = sum(map(float, WORKED.findall(text)))
        if lonely == 0 or work > SEARCH_PATIENCE:
            break
    return best[2]


def theirs(object, most_accurate, arguments, folder):
    entries = []
    if shutil.which("povray"):
        pov, picture = folder / f"{object.name}.pov", folder / f"{object.name}-pov.png"
        gradient = max_gradient(object, most_accurate, folder)
        pov.write_text(object.pov(arguments.size, gradient))
        entries.append(Entry("povray", f"max_gradient {gradient:g}",
                             povray.command(pov, arguments.size, picture), picture))
    if object.example and shutil.which("jsurf-alggeo"):
        picture = folder / f"{object.name}-jsurf.png"
        shown = on_magenta(object.example, folder)
        entries.append(Entry("jsurf-alggeo", "quality 0",
                             jsurf_command(shown, arguments.size, picture), picture))
    return entries


TRACED = re.compile(r"Trace Time:.*\(([\d.]+) seconds\)")


def rows_of(object, arguments, folder):
    scene = folder / f"{object.name}.toml"
    scene.write_text(object.scene(arguments.size))
    entries = [ours(object, method, arguments, folder, scene) for method in arguments.methods]
    able = [e for e in entries if not e.failed]
    if not able:
        sys.exit(f"{object.name}: {entries[0].failed}")
    most_accurate = min(able, key=lambda e: (e.wrong_ppm, e.frame_ms))
    entries += theirs(object, most_accurate, arguments, folder)
    traced = {}
    for _ in range(arguments.repeat):
        for entry in entries:
            if entry.failed:
                continue
            took, text = seconds(entry.command)
            if took is None:
                entry.failed = (text.strip().splitlines() or ["failed"])[-1]
                continue
            entry.times.append(took)
            if found := TRACED.search(text):
                traced.setdefault(entry.program, []).append(1e3 * float(found[1]))
    right = hits(most_accurate.picture)
    rows = []
    for entry in entries:
        row = {"object": object.name, "program": entry.program, "setting": entry.setting,
               "size": arguments.size, "process_s": "", "frame_ms": "", "wrong_ppm": "",
               "differ": "", "off_silhouettes": "", "failed": entry.failed}
        if not entry.failed:
            frame = entry.frame_ms
            if entry.program in traced:
                frame = statistics.median(traced[entry.program])
            differ, lonely = differences(right, hits(entry.picture))
            row |= {"process_s": f"{statistics.median(entry.times):.3f}",
                    "frame_ms": "" if frame is None else f"{frame:.2f}",
                    "wrong_ppm": "" if entry.wrong_ppm is None else f"{entry.wrong_ppm:.1f}",
                    "differ": differ, "off_silhouettes": lonely}
        rows.append(row)
        print(" | ".join(str(value) for value in row.values()), flush=True)
    return rows


def version(program):
    asked = {"povray": ["povray", "--version"], "jsurf-alggeo": ["jsurf-alggeo", "--version"]}
    text = subprocess.run(asked[program], capture_output=True, text=True)
    lines = (text.stdout + text.stderr).splitlines()
    number = next((line.strip() for line in lines if re.search(r"\d\.\d+\.\d", line)), "?")
    return number if program.lower() in number.lower().replace("-", "") else f"{program} {number}"


def markdown(rows, arguments, missing):
    versions = ", ".join(version(p) for p in PEERS if p not in missing)
    lines = ["# Beside other programs", "",
             f"{arguments.size}x{arguments.size}, medians of {arguments.repeat} runs, all programs "
             "in turn; made by", "`tests/bench/peers.py`, whose head tells how settings were "
             f"chosen. {versions or 'No peer installed'}.", ""]
    lines += [f"Not installed, so left out: {p} (apt-get install {PEERS[p]})." for p in missing]
    lines += ["", "| object | program | setting | process, s | frame, ms | wrong ppm | differ | "
              "off silhouettes |", "|---|---|---|--:|--:|--:|--:|--:|"]
    for row in rows:
        cells = [row[k] for k in ("object", "program", "setting", "process_s", "frame_ms",
                                  "wrong_ppm", "differ", "off_silhouettes")]
        if row["failed"]:
            cells[3] = "no: " + row["failed"].replace("|", "\\|")[:100]
        lines.append("| " + " | ".join(map(str, cells)) + " |")
    lines += ["", "*Wrong*: certainly, against truth. *Differ*: pixels hit here and missed in the "
              "most accurate", "picture of isomotion, or the other way round; off silhouettes no "
              "rounding explains them.", ""]
    return "\n".join(lines)


# Told apart by shape too, and in every kind of colour blindness (Okabe & Ito).
COLOURS = ["#0072b2", "#000000", "#56b4e9", "#d55e00", "#009e73", "#cc79a7", "#e69f00"]
MARKS = [5, 7, 9, 11, 13, 15, 4]


def plot(rows, file):
    """Time of a whole process and, lighter, of its frame alone, object by object."""
    names = list(dict.fromkeys(row["object"] for row in rows))
    programs = list(dict.fromkeys(program_of(row) for row in rows))
    blocks, curves = [], []
    for k, program in enumerate(programs):
        style = f"pt {MARKS[k % len(MARKS)]} lc rgb"
        colour, title = COLOURS[k % len(COLOURS)], f"title '{program}'"
        for column, scale, drawn in (("process_s", 1, f"ps 1 {style} '{colour}' {title}"),
                                     ("frame_ms", 1e-3, f"ps 0.6 {style} '#90{colour[1:]}' notitle")):
            points = [(names.index(row["object"]) + 0.12 * (k - len(programs) / 2),
                       scale * float(row[column]))
                      for row in rows if program_of(row) == program and row[column]]
            if not points:
                continue
            block = f"$block{len(blocks)}"
            blocks.append(f"{block} << E\n" + "".join(f"{x} {y}\n" for x, y in points) + "E\n")
            curves.append(f"{block} with points {drawn}")
    tics = ", ".join(f"'{name.removeprefix('record_')}' {k}" for k, name in enumerate(names))
    script = (f"set terminal svg size 900,420 dynamic noenhanced background '#ffffff'\n"
              f"set output '{file}'\nset grid y lc rgb '#dddddd'\nset key outside right\n"
              f"set logscale y\nset format y '%g'\nset ylabel 'seconds: process, and (small) frame'\n"
              f"set xrange [-0.7:{len(names) - 0.3}]\nset xtics ({tics}) rotate by -20\n"
              + "".join(blocks) + "plot " + ", ".join(curves) + "\n")
    subprocess.run(["gnuplot"], input=script, text=True, check=True)


def program_of(row):
    return (row["setting"].split(",")[0] if row["program"] == "isomotion" else row["program"])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*", default=NAMES)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--repeat", type=int, default=5)
    parser.add_argument("--methods", help="a,b (default: all)")
    parser.add_argument("--pictures", action="store_true", help="keep what each program drew")
    parser.add_argument("--isomotion", default=str(ROOT / "build/release/isomotion"))
    arguments = parser.parse_args()
    listed = arguments.methods.split(",") if arguments.methods else methods_of(arguments.isomotion)
    arguments.methods = listed
    missing = [program for program in PEERS if not shutil.which(program)]
    for program in missing:
        print(f"{program} is not installed and left out: apt-get install {PEERS[program]}",
              file=sys.stderr)
    arguments.output.mkdir(parents=True, exist_ok=True)
    rows = []
    with tempfile.TemporaryDirectory() as folder:
        for name in arguments.names:
            object = blobby75(arguments.isomotion) if name == "blobby75" else of_jsurf(name)
            if object is None:
                print(f"{name}: no such example of jsurf-alggeo in {EXAMPLES}, left out",
                      file=sys.stderr)
                continue
            rows += rows_of(object, arguments, pathlib.Path(folder))
            with (arguments.output / "peers.csv").open("w", newline="") as file:
                writer = csv.DictWriter(file, rows[0].keys())
                writer.writeheader()
                writer.writerows(rows)
            (arguments.output / "peers.md").write_text(markdown(rows, arguments, missing))
        if arguments.pictures:
            for picture in pathlib.Path(folder).glob("*.png"):
                shutil.copy(picture, arguments.output)
    if shutil.which("gnuplot"):
        plot(rows, arguments.output / "peers.svg")
    else:
        print("gnuplot is not installed, so nothing is plotted: apt-get install gnuplot-nox",
              file=sys.stderr)
    print(arguments.output / "peers.md")


if __name__ == "__main__":
    main()

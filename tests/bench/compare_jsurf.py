#!/usr/bin/env python3
"""Holds certified truth against another renderer: pixels hit or missed by jsurf-alggeo.

    tests/bench/compare_jsurf.py [--size 512] [--scenes] [--isomotion build/release/isomotion] [NAME...]

Draws Debian's examples of jsurf-alggeo (which needs a Java runtime: default-jre-headless) with
quality 0, one sample a pixel, and the same equation, view and clipping sphere here, with a step so
small that `isomotion accuracy` finds no pixel wrong against truth. Prints how many pixels differ,
and how many of those have no neighbour on the other side: silhouettes may fall either way.

With --scenes, the files are rendered as they are, as scenes, by default all of them.
"""
import argparse
import math
import pathlib
import re
import subprocess
import sys
import tempfile
import zlib

EXAMPLES = pathlib.Path("/usr/share/doc/jsurf-alggeo/examples")
NAMES = ["record_endrass", "record_labsseptic", "record_barthsextic", "record_chmutovoktic"]


def read_png(file):
    """Rows of 8-bit RGB or RGBA pixels as tuples; enough of PNG for what the two programs write."""
    data = pathlib.Path(file).read_bytes()
    at, body = 8, b""
    while at < len(data):
        length = int.from_bytes(data[at:at + 4], "big")
        kind, chunk = data[at + 4:at + 8], data[at + 8:at + 8 + length]
        if kind == b"IHDR":
            width, height = (int.from_bytes(chunk[k:k + 4], "big") for k in (0, 4))
            depth, colour = chunk[8], chunk[9]
        if kind == b"IDAT":
            body += chunk
        at += 12 + length
    if depth != 8 or colour not in (2, 6):
        sys.exit(f"{file}: neither RGB nor RGBA in 8 bits")
    size = 3 if colour == 2 else 4
    raw, rows, last = zlib.decompress(body), [], bytes(width * size)
    for y in range(height):
        line = bytearray(raw[y * (width * size + 1):(y + 1) * (width * size + 1)])
        method, line = line[0], line[1:]
        for k in range(len(line)):
            a = line[k - size] if k >= size else 0
            b = last[k]
            c = last[k - size] if k >= size else 0
            if method == 1:
                line[k] = (line[k] + a) & 255
            elif method == 2:
                line[k] = (line[k] + b) & 255
            elif method == 3:
                line[k] = (line[k] + (a + b) // 2) & 255
            elif method == 4:
                p = a + b - c
                near = min((abs(p - a), 0, a), (abs(p - b), 1, b), (abs(p - c), 2, c))[2]
                line[k] = (line[k] + near) & 255
        rows.append([tuple(line[k:k + size]) for k in range(0, len(line), size)])
        last = bytes(line)
    return rows


def scene_of(example, size):
    """The example as a scene. Their picture is 2 units high from the first pixel's middle to the
    last one's, and clipped to the unit ball."""
    keys = dict(line.split("=", 1) for line in example.read_text().splitlines()
                if "=" in line and not line.startswith("#"))
    parameters = {m: keys[f"surface_parameter_{m}"] for m in "abcd"
                  if f"surface_parameter_{m}" in keys}
    formula = keys["surface_equation"]
    used = {m: v for m, v in parameters.items() if re.search(rf"(?<![a-z]){m}(?![a-z])", formula)}
    radius = 10 ** float(keys["scale_factor"])
    m = [float(v) for v in keys["rotation_matrix"].split()]
    # The camera's axes are the columns.
    up, back = m[1::4][:3], m[2::4][:3]
    vector = lambda v, s=1: "[" + ", ".join(repr(s * c) for c in v) + "]"
    return "\n".join(
        [f'title = "{example.stem}"', "[surface]", f'formula = "{formula}"',
         f"bounds = {{ sphere = {radius!r} }}", "[parameters]"] +
        [f"{name} = {value}" for name, value in used.items()] +
        ["[camera]", 'projection = "orthographic"', f"height = {2 * radius!r}",
         f"zoom = {(size - 1) / size!r}",
         f"position = {vector(back, 3 * radius)}", f"up = {vector(up)}", "[output]",
         'background = "transparent"', ""])


def on_magenta(example, folder):
    """The example on a background that no shade of the surface passes for, as white does."""
    shown = folder / example.name
    shown.write_text(re.sub(r"background_color=.*", "background_color=1.0 0.0 1.0",
                            example.read_text()))
    return shown


def jsurf_command(shown, size, picture):
    return ["jsurf-alggeo", "-q", "0", "-s", str(size), "-o", str(picture), str(shown)]


def hits(picture, background=(255, 0, 255)):
    """Rows of booleans: what is drawn, on nothing or on magenta or another colour."""
    return [[pixel[3:] != (0,) and pixel[:3] != background for pixel in row]
            for row in read_png(picture)]


def differences(a, b):
    """How many pixels of b differ from a, and how many of these are off any silhouette of a."""
    size, differ, lonely = len(a), 0, 0
    for y in range(size):
        for x in range(size):
            if a[y][x] == b[y][x]:
                continue
            differ += 1
            around = [a[v][u] for v in range(max(0, y - 1), min(size, y + 2))
                      for u in range(max(0, x - 1), min(size, x + 2))]
            lonely += len(set(around)) == 1
    return differ, lonely


def compare(name, size, isomotion, folder):
    example = EXAMPLES / f"{name}.jsurf"
    theirs = folder / f"{name}.jsurf.png"
    subprocess.run(jsurf_command(on_magenta(example, folder), size, theirs), check=True)
    scene = folder / f"{name}.toml"
    scene.write_text(scene_of(example, size))
    for halvings in range(3, 9):
        step = 10 ** float(re.search(r"scale_factor=(\S+)", example.read_text())[1]) / 100 / 2**halvings
        right = subprocess.run([isomotion, "accuracy", scene, "--size", f"{size}x{size}", "--methods",
                                "amp-sign", "--steps", repr(step), "--repeat", "1", "--quiet",
                                "--max-wrong", "0"], stdout=subprocess.PIPE,
                               stderr=subprocess.DEVNULL).returncode == 0
        if right:
            break
    ours = folder / f"{name}.png"
    subprocess.run([isomotion, "render", scene, "--size", f"{size}x{size}", "--step", repr(step),
                    "--quiet", "-o", ours], check=True)
    a, b = hits(ours), hits(theirs)
    differ, lonely = differences(a, b)
    print(f"{name:22} {size}x{size}: {sum(map(sum, a))} hit, {differ} differ "
          f"({1e6 * differ / size**2:.0f} ppm), {lonely} of them off any silhouette; "
          f"step {step:.3g}, {'no' if right else 'SOME'} pixel wrong against truth", flush=True)


def compare_scene(name, size, isomotion, folder):
    example = EXAMPLES / f"{name}.jsurf"
    theirs, ours = folder / f"{name}.jsurf.png", folder / f"{name}.png"
    subprocess.run(jsurf_command(on_magenta(example, folder), size, theirs), check=True)
    # Their picture reaches from the first pixel's middle to the last one's.
    subprocess.run([isomotion, "render", example, "--size", f"{size}x{size}", "--set",
                    f"camera.zoom={(size - 1) / size!r}", "--set", "output.background=transparent",
                    "--quiet", "-o", ours], check=True)
    a, b = hits(ours), hits(theirs)
    differ, lonely = differences(a, b)
    print(f"{name:28} {size}x{size}: {sum(map(sum, a))} hit, {differ} differ, {lonely} of them off any "
          "silhouette", flush=True)


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("names", nargs="*")
    parser.add_argument("--scenes", action="store_true")
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--isomotion", default="build/release/isomotion")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        everything = sorted(file.stem for file in EXAMPLES.glob("*.jsurf"))
        for name in arguments.names or (everything if arguments.scenes else NAMES):
            (compare_scene if arguments.scenes else compare)(
                name, arguments.size, arguments.isomotion, pathlib.Path(folder))


if __name__ == "__main__":
    main()

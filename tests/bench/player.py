#!/usr/bin/env python3
"""Turns the camera of animations in the player, and tells what was shown.

    tests/bench/player.py -o FOLDER [--seconds 4] [--window 1000x700] [--program FILE] [NAME...]

Each animation (default: the whole gallery) is played in a window of an Xvfb of its own, while the
mouse turns the camera by xdotool. Of the pictures shown meanwhile, after the first half second in
which their size finds itself, the table tells

    a second     how many there were
    smallest     the smallest scale used, as a part of the window's sides (the least there is: 1/16)
    usual        the median scale
    pixels       the median root of the picture's area
    draw         the median time of a draw, ms
    longest gap  between two pictures, ms
    to picture   how many pictures came from the moment that a picture was asked for, which an event
                 does at once, until it was on the screen, itself among them; the most
    window       seconds from the start of the program to its window

Needs Xvfb and xdotool. Writes player.csv and player.md.
"""
import argparse
import csv
import json
import math
import os
import pathlib
import shutil
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
FINDS_ITSELF = 0.5   # seconds
TURNS_EVERY = 1 / 60
PATIENCE = 120


class NoPictures(Exception):
    pass


class Display:
    def __init__(self, width, height):
        told, tell = os.pipe()
        self.server = subprocess.Popen(
            ["Xvfb", "-displayfd", str(tell), "-screen", "0", f"{width}x{height}x24", "-nolisten", "tcp", "-noreset"],
            pass_fds=[tell], stderr=subprocess.DEVNULL)
        os.close(tell)
        with os.fdopen(told) as line:
            number = line.readline().strip()
        if not number:
            sys.exit("Xvfb does not start")
        self.environment = dict(os.environ, DISPLAY=f":{number}")

    def drive(self, *words, must=True):
        """Whether xdotool did so; if it must, an error otherwise."""
        return subprocess.run(["xdotool", *map(str, words)], env=self.environment, check=must,
                              stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL).returncode == 0

    def end(self):
        self.server.terminate()
        self.server.wait()


def lines_of(log):
    """What the player wrote so far; its last line may be half written."""
    found = []
    for line in log.read_text().splitlines() if log.exists() else []:
        try:
            found.append(json.loads(line))
        except json.JSONDecodeError:
            pass
    return found


def expect_at_work(player, begin):
    if player.poll() is not None:
        raise NoPictures(f"the player ended with {player.returncode}")
    if time.monotonic() > begin + PATIENCE:
        raise NoPictures(f"nothing in {PATIENCE} s")


def await_picture(log, player, begin):
    while not any("scale" in line for line in lines_of(log)):
        expect_at_work(player, begin)
        time.sleep(0.02)


def turn(display, centre, radius, seconds):
    """Drags the mouse round, with an event every 1/60 s."""
    driver = subprocess.Popen(["xdotool", "-"], stdin=subprocess.PIPE, env=display.environment, text=True)
    begin = time.monotonic()

    def say(text):
        driver.stdin.write(text + "\n")
        driver.stdin.flush()

    say(f"mousemove {centre[0] + radius} {centre[1]}")
    say("mousedown 1")
    step = 0
    while time.monotonic() - begin < seconds:
        angle = 2 * math.pi * step / 180
        say(f"mousemove {round(centre[0] + radius * math.cos(angle))} {round(centre[1] + radius * math.sin(angle))}")
        step += 1
        time.sleep(max(0.0, begin + step * TURNS_EVERY - time.monotonic()))
    say("mouseup 1")
    driver.stdin.close()
    driver.wait()


def measure(display, program, name, size, seconds):
    with tempfile.TemporaryDirectory() as folder:
        log = pathlib.Path(folder) / "log"
        begin = time.monotonic()
        player = subprocess.Popen([program, "play", name, "--forget", "--log", log], cwd=folder,
                                  env=display.environment, stderr=subprocess.DEVNULL)
        try:
            return {"animation": name} | watch(display, player, log, begin, size, seconds)
        finally:
            player.kill()
            player.wait()


def watch(display, player, log, begin, size, seconds):
    while not display.drive("search", "--onlyvisible", "--name", "isomotion", must=False):
        expect_at_work(player, begin)
        time.sleep(0.02)
    opened = time.monotonic() - begin
    display.drive("search", "--onlyvisible", "--name", "isomotion", "windowsize", *size, "windowmove", 0, 0,
                  "windowfocus", "--sync")
    # A picture that compiled says that the shader is there.
    await_picture(log, player, begin)
    time.sleep(0.3)
    line = [l for l in lines_of(log) if "scale" in l][-1]
    centre = [line["corner"][k] + line["size"][k] // 2 for k in (0, 1)]
    since = line["seconds"]
    turn(display, centre, min(line["size"]) // 4, seconds + FINDS_ITSELF)
    shown = [l for l in lines_of(log) if "scale" in l and since + FINDS_ITSELF < l["seconds"] and not l["at_rest"]
             and l["seconds"] < since + FINDS_ITSELF + seconds]
    if len(shown) < 2:
        raise NoPictures(f"fewer than two pictures in {seconds:g} s")
    times = [l["seconds"] for l in shown]
    to_picture = [sum(l["asked"] < at <= l["seconds"] for at in times) for l in shown]
    return {
        "pictures_a_second": (len(times) - 1) / (times[-1] - times[0]),
        "smallest_scale": min(l["scale"] for l in shown),
        "usual_scale": statistics.median(l["scale"] for l in shown),
        "pixels_a_side": statistics.median(math.sqrt(math.prod(l["drawn"])) for l in shown),
        "draw_ms": statistics.median(l["milliseconds"] for l in shown),
        "longest_gap_ms": 1e3 * max(b - a for a, b in zip(times, times[1:])),
        "to_picture": max(to_picture),
        "window_s": opened,
    }


def table(rows, without, arguments):
    text = (f"# The player, while its camera is turned\n\nWindow of {arguments.window}, {arguments.seconds:g} s of "
            f"each animation played; {os.cpu_count()} threads. Made by `tests/bench/player.py`.\n\n"
            "| animation | a second | smallest | usual | pixels | draw, ms | longest gap, ms | to picture | "
            "window, s |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|\n")
    for r in rows:
        text += (f"| {r['animation']} | {r['pictures_a_second']:.1f} | {r['smallest_scale']:.2f} | "
                 f"{r['usual_scale']:.2f} | {r['pixels_a_side']:.0f} | {r['draw_ms']:.1f} | "
                 f"{r['longest_gap_ms']:.0f} | {r['to_picture']} | {r['window_s']:.2f} |\n")
    if without:
        text += "\nWithout pictures: " + "; ".join(without) + ".\n"
    return text


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("-o", "--output", type=pathlib.Path, required=True)
    parser.add_argument("--seconds", type=float, default=4)
    parser.add_argument("--window", default="1000x700")
    parser.add_argument("--program", type=lambda name: pathlib.Path(name).resolve(), default=ROOT / "build/release/isomotion")
    parser.add_argument("names", nargs="*")
    arguments = parser.parse_args()
    for needed in ("Xvfb", "xdotool"):
        if not shutil.which(needed):
            sys.exit(f"{needed} is not installed")
    names = arguments.names or sorted(path.stem for path in (ROOT / "animations").glob("*.toml"))
    size = [int(side) for side in arguments.window.split("x")]
    arguments.output.mkdir(parents=True, exist_ok=True)
    display = Display(*size)
    rows, without = [], []
    try:
        for name in names:
            try:
                rows.append(measure(display, arguments.program, name, size, arguments.seconds))
            except (NoPictures, BrokenPipeError, subprocess.SubprocessError) as why:
                print(name, why, flush=True)
                without.append(f"{name}: {why}")
                continue
            print(*(f"{value:.2f}" if isinstance(value, float) else value for value in rows[-1].values()), flush=True)
    finally:
        display.end()
        (arguments.output / "player.md").write_text(table(rows, without, arguments))
        if rows:
            with open(arguments.output / "player.csv", "w", newline="") as file:
                writer = csv.DictWriter(file, rows[0].keys())
                writer.writeheader()
                writer.writerows(rows)


if __name__ == "__main__":
    main()

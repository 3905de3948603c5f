#!/usr/bin/env python3
"""The time of a frame in a page against that of `isomotion render`, both on the machine's llvmpipe.

    tests/bench/page_times.py [--program FILE] [--size 512] [--first 11] [--frames 6] [--rounds 3]
                              [NAME...]

Chromium draws with the EGL that `render` has (--use-angle=gl-egl). Of each animation the table tells
the milliseconds of a frame, page and render, their ratio, and the time from opening the page to its
first picture. A frame of a page begins with its values and ends when a pixel of the canvas was read
back; one of `render` ends with the picture in memory (its own count of time spent drawing, less that
of the first frame, which waits for the compiler). Rounds of both take turns, and the least of each
counts, as other programs only add to it.

The last columns tell processor time, which differs less on a machine that others use: of the
browser's process that draws, and of `render` with all it does, its files written. Both are medians
over the rounds.
"""
import argparse
import os
import pathlib
import re
import resource
import statistics
import subprocess
import sys
import tempfile
import time

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tests" / "page"))
import browser  # noqa: E402

NAMES = ["blobby75", "twisting_superquadric", "barth_decic", "chmutov_14", "falling_drops", "torus",
         "sliced_gyroid", "chmutov_12_two_lights", "blobby75_chrome"]
ONE_PICTURE = ["--set", "look=none", "--set", "output.samples=1"]
# Frames one by one, drawn and shown.
FRAMES = """(async () => {
    const { painter } = isomotion, { gl } = painter, side = %d, all = [];
    for (let frame = %d; frame <= %d; ++frame) {
        const begin = performance.now();
        painter.screen.begin(side, side);
        await painter.drawPicture(painter.picture(frame, side, side, 0), () => {});
        painter.screen.show();
        gl.bindFramebuffer(gl.FRAMEBUFFER, null);
        gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, new Uint8Array(4));
        all.push(performance.now() - begin);
    }
    return all;
})()"""


def run(program, *words):
    return subprocess.run([program, *words], capture_output=True, text=True, check=True,
                          env={**os.environ, "LP_NUM_THREADS": str(os.cpu_count())}).stdout


def processor_seconds(process):
    """The processor time of a process that runs, the user's and the system's together."""
    with open(f"/proc/{process}/stat") as stat:
        fields = stat.read().rsplit(")", 1)[1].split()
    return (int(fields[11]) + int(fields[12])) / os.sysconf("SC_CLK_TCK")


def drawing_process(of_browser):
    """The process that draws, among all that a browser started."""
    parents = {}
    for entry in filter(str.isdigit, os.listdir("/proc")):
        try:
            with open(f"/proc/{entry}/stat") as stat:
                parents[int(entry)] = int(stat.read().rsplit(")", 1)[1].split()[1])
        except OSError:
            continue  # it has ended
    for process in parents:
        above = process
        while above in parents and above != of_browser:
            above = parents[above]
        if above != of_browser:
            continue
        with open(f"/proc/{process}/cmdline") as line:
            if "--type=gpu-process" in line.read():
                return process
    raise RuntimeError("the browser has no process that draws")


def of_children():
    used = resource.getrusage(resource.RUSAGE_CHILDREN)
    return used.ru_utime + used.ru_stime


def seconds_of_drawing(program, name, folder, side, last, first):
    """Seconds by the clock, as `render` tells them, and of processors, with all that it does."""
    before = of_children()
    told = run(program, "render", name, "--frames", f"{first}-{last}", "--size", f"{side}x{side}",
               "--audit", "off", "-o", os.path.join(folder, "r.####.png"), *ONE_PICTURE)
    drawn = float(re.search(r"drawn \d+ in ([\d.]+) s", told).group(1))
    return drawn, of_children() - before


def measure(given, driven, folder, name):
    side, first = given.size, given.first
    last = first + given.frames
    file = os.path.join(folder, "page.html")
    run(given.program, "page", name, "-o", file, "--quiet", *ONE_PICTURE)
    page = driven.page(side, side)
    begin = time.time()
    page.open(file, "?ui=0&play=0&samples=1", f"#f={first}")
    page.until("isomotion.painter.drawn > 0")
    opened = time.time() - begin
    page.until_at_rest()
    of_page, of_render, used = [], [], []
    draws = drawing_process(driven.process.pid)
    for _ in range(given.rounds):
        before = processor_seconds(draws)
        of_page += page.evaluate(FRAMES % (side, first, last))[1:]
        by_page = (processor_seconds(draws) - before) / (given.frames + 1)
        one = seconds_of_drawing(given.program, name, folder, side, first, first)
        all_ = seconds_of_drawing(given.program, name, folder, side, last, first)
        by_clock, by_render = [(a - b) / given.frames for a, b in zip(all_, one)]
        of_render.append(1e3 * by_clock)
        used.append((1e3 * by_page, 1e3 * by_render))
    page.close()
    # The least over frames of one kind; medians within a round of pages are of unlike frames.
    rounds = [statistics.mean(of_page[k:k + given.frames])
              for k in range(0, len(of_page), given.frames)]
    processors = [statistics.median(times) for times in zip(*used)]
    return min(rounds), min(of_render), opened, *processors


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", default=str(ROOT / "build" / "release" / "isomotion"))
    parser.add_argument("--size", type=int, default=512)
    parser.add_argument("--first", type=int, default=11, help="frame before those that count")
    parser.add_argument("--frames", type=int, default=6)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("names", nargs="*", default=NAMES)
    given = parser.parse_args()
    os.environ["LP_NUM_THREADS"] = str(os.cpu_count())
    print("| animation | page, ms | render, ms | ratio | first picture, s | page, processor ms | "
          "render, processor ms | ratio |\n|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as folder, browser.Browser(gl=browser.SYSTEM_GL) as driven:
        for name in given.names:
            page, render, opened, by_page, by_render = measure(given, driven, folder, name)
            print(f"| {name} | {page:.1f} | {render:.1f} | {page / render:.2f} | {opened:.2f} | "
                  f"{by_page:.0f} | {by_render:.0f} | {by_page / by_render:.2f} |", flush=True)


if __name__ == "__main__":
    main()

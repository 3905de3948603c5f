#!/usr/bin/env python3
"""Records what a build of isomotion draws, so that a redesign can be shown to change nothing.

    tests/bench/behaviour.py build/release/isomotion -o before.txt
    tests/bench/behaviour.py build/other/isomotion --against before.txt

A line a picture: its name, a hash of its pixels with every channel, the outcomes of its rays and the
evaluations of its field. Pictures are the poster of every animation of the gallery by every method,
and the scenes of tests/bench/behaviour by every stage, which together use every effect and channel;
after them comes what `show` says of each. --against ends with 1 and tells each line that differs;
--only keeps the names that hold a word. Hashes differ between machines and drivers: record both
sides on one.
"""

import argparse
import concurrent.futures
import difflib
import hashlib
import json
import os
import pathlib
import subprocess
import sys
import tempfile

SCENES = sorted((pathlib.Path(__file__).parent / "behaviour").glob("*.toml"))


def run(program, *arguments):
    return subprocess.run([program, *map(str, arguments)], text=True, capture_output=True,
                          env={**os.environ, "LP_NUM_THREADS": "1"})


def listed(program, what):
    return [line.split()[0] for line in run(program, "list", what).stdout.splitlines() if line.strip()]


def picture(program, name, arguments):
    """The record of one drawn frame, as `render` keeps it."""
    with tempfile.TemporaryDirectory() as folder:
        done = run(program, "render", *arguments, "--quiet", "-o", f"{folder}/f.####.exr")
        frames = sorted(pathlib.Path(folder).glob("f.exr.manifest/[0-9]*.json"))
        if done.returncode != 0 or not frames:
            # A method that the scene's formula has no use for says so; its words are recorded.
            return f"{name}\texit {done.returncode}\t{done.stderr.strip().splitlines()[:1]}"
        parts = []
        for frame in frames:
            kept = json.loads(frame.read_text())
            parts += [kept["pixels"], str(sorted(kept["rays"].items())), str(kept["evaluations"]),
                      str(kept.get("proofs", ""))]
        return "\t".join([name, *parts])


def shown(program, name, arguments):
    done = run(program, "show", *arguments)
    digest = hashlib.sha256((done.stdout + done.stderr).encode()).hexdigest()[:32]
    return f"{name}\t{digest}"


def jobs(program):
    channels = "z,n,p,verdict,evaluations"
    small = ["--size", "128x128", "--channels", channels]
    for animation in listed(program, "animations"):
        for method in listed(program, "methods"):
            yield picture, f"{animation} {method}", [animation, "--frames", "poster", "--method", method, *small]
        yield shown, f"{animation} show", [animation]
    for scene in SCENES:
        for stage in ("fragment", "compute"):
            # Both sides lie over the gallery's, so that pictures have several tiles of beams.
            yield picture, f"{scene.stem} {stage}", [scene, "--stage", stage, "--size", "200x150", "--frames",
                                                     "2,5", "--channels", channels + ",velocity"]
        yield picture, f"{scene.stem} proved", [scene, "--size", "96x96", "--frames", "2", "--certify",
                                                "--channels", "z,proof"]
        yield shown, f"{scene.stem} show", [scene]


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("program")
    parser.add_argument("-o", "--output")
    parser.add_argument("--against")
    parser.add_argument("--only", default="")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    options = parser.parse_args()
    program = str(pathlib.Path(options.program).resolve())
    with concurrent.futures.ThreadPoolExecutor(options.jobs) as pool:
        waiting = [pool.submit(kind, program, name, arguments)
                   for kind, name, arguments in jobs(program) if options.only in name]
        lines = [job.result() for job in waiting]
    if options.output:
        pathlib.Path(options.output).write_text("\n".join(lines) + "\n")
    if not options.against:
        return 0
    before = [line for line in pathlib.Path(options.against).read_text().splitlines()
              if options.only in line.split("\t")[0]]
    changes = [line for line in difflib.unified_diff(before, lines, "before", "now", n=0, lineterm="")]
    print("\n".join(changes) if changes else f"{len(lines)} records, all as before")
    return 1 if changes else 0


if __name__ == "__main__":
    sys.exit(main())

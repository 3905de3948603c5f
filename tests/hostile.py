#!/usr/bin/env python3
"""What strangers' files and failing machines are tried with, and how much of it held.

    tests/hostile.py BUILD

Runs those tests of a build that docs/security.md names and prints a row for each kind. A test that
draws or loops tells how many inputs it tried and how many held (RecordProperty); others count as one.
Those that draw take ISOMOTION_SEED from the environment, or a seed of this run's own. Ends with 1
unless all held.
"""

import json
import os
import pathlib
import random
import subprocess
import sys
import tempfile

KINDS = [
    ("limits of scenes, and one more", "unit/scene/scene_test", "Limits.*"),
    ("files that scenes name", "unit/scene/scene_test", "Scenes.*:Outside.*"),
    ("files that change before they are opened", "unit/base/base_test", "Confined.*"),
    ("what tables keep", "unit/scene/scene_test", "ElementTables.TakeOff*:ElementTables.Several*"),
    ("particles of every format", "unit/scene/particles_test", "*"),
    ("slips in scenes", "unit/scene/scene_test", "*Mistakes*"),
    ("pictures of light", "unit/image/image_test", "EnvironmentFile.*"),
    ("names and numbers that reach shaders", "fuzz/hostile_scene_test", "*"),
    ("what fuzzers learnt and found", "fuzz/fuzz_replay_test", "*Replay*"),
    ("manifests", "unit/sequence/sequence_test", "ManifestJson.*:ManifestFolder.*:RecordingTest.*"),
    ("scenes on the command line", "cli/cli_test", "Stranger.*"),
    ("manifests on the command line", "cli/cli_test", "Verify.*"),
    ("drawn command lines", "cli/cli_test", "DrawnCommandLines.*"),
    ("drawn effects", "cli/cli_test", "DrawnEffects.*"),
    ("outputs and machines that refuse", "cli/cli_test", "Machine.*"),
    ("places that vanish or are full", "faults/faults_test", "Places.*"),
    ("several at once", "faults/faults_test", "Several.*"),
    ("kills", "faults/faults_test", "*Kills*"),
    ("system calls that fail once", "faults/faults_test", "*FailingCalls*"),
]


def cases(build, binary, selection, folder):
    """How often each case of a test binary was tried, and how often it held."""
    report = folder / "report.json"
    report.unlink(missing_ok=True)
    words = [str(build / "tests" / binary), f"--gtest_filter={selection}", f"--gtest_output=json:{report}"]
    run = subprocess.run(words, cwd=(build / "tests" / binary).parent, capture_output=True, text=True)
    if not report.exists():
        raise SystemExit(f"{binary} {selection} ended without a report:\n{run.stdout}{run.stderr}")
    for suite in json.loads(report.read_text())["testsuites"]:
        for case in suite["testsuite"]:
            name = f"{suite['name']}.{case['name']}"
            if case["result"] == "SKIPPED":
                print(f"skipped: {name}", file=sys.stderr)
                continue
            tried = int(case.get("tried", 1))
            failed = "failures" in case
            held = int(case["held"]) if "held" in case else 0 if failed else tried
            if failed:
                print(f"failed: {name}", file=sys.stderr)
            yield tried, min(held, tried - 1) if failed else held


def main():
    if len(sys.argv) != 2:
        raise SystemExit(__doc__)
    build = pathlib.Path(sys.argv[1]).resolve()
    all_tried = all_held = 0
    seed = os.environ.setdefault("ISOMOTION_SEED", str(random.randrange(1, 10**6)))
    print(f"ISOMOTION_SEED={seed}")
    print("| what is tried | tried | held |\n|---|--:|--:|")
    with tempfile.TemporaryDirectory() as folder:
        for what, binary, selection in KINDS:
            counts = list(cases(build, binary, selection, pathlib.Path(folder)))
            if not counts:
                raise SystemExit(f"no test of {binary} is named {selection}")
            tried, held = (sum(column) for column in zip(*counts))
            print(f"| {what} | {tried} | {held} |", flush=True)
            all_tried += tried
            all_held += held
    print(f"| all | {all_tried} | {all_held} |")
    sys.exit(all_held < all_tried)


if __name__ == "__main__":
    main()

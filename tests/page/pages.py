"""What the tests of pages share: the program, a folder of their own, a browser."""
import argparse
import os
import subprocess
import sys
import tempfile

import browser


def arguments(**more):
    parser = argparse.ArgumentParser()
    parser.add_argument("program")
    for name, options in more.items():
        parser.add_argument(name, **options)
    return parser.parse_args()


def run(program, *words, folder=None, seconds=300):
    environment = {**os.environ, "LP_NUM_THREADS": os.environ.get("LP_NUM_THREADS", "2")}
    return subprocess.run([program, *words], cwd=folder, env=environment, text=True,
                          capture_output=True, timeout=seconds)


def made(program, scene, file, *more):
    """The page of a scene; its path."""
    ending = run(program, "page", scene, "-o", file, "--quiet", *more)
    if ending.returncode != 0:
        raise AssertionError(f"page {scene}: {ending.returncode}: {ending.stderr}")
    return file


class Checks:
    """Counts what does not hold and goes on."""

    def __init__(self):
        self.failures = []

    def expect(self, holds, what):
        if holds:
            return
        self.failures.append(what)
        print(f"FAILED {what}", flush=True)

    def equal(self, found, wanted, what):
        self.expect(found == wanted, f"{what}: {found!r}, not {wanted!r}")


def main(test, **more):
    """Runs test(arguments, folder, browser, checks) and ends as ctest wants it."""
    given = arguments(**more)
    # ISOMOTION_PROGRAM: a program of another build, with sanitizers.
    given.program = os.path.abspath(os.environ.get("ISOMOTION_PROGRAM") or given.program)
    reason = browser.missing()
    if reason:
        print(f"skipped: {reason}")
        sys.exit(browser.SKIPPED)
    checks = Checks()
    with tempfile.TemporaryDirectory(prefix="isomotion-page-") as folder:
        with browser.Browser() as driven:
            test(given, folder, driven, checks)
    print(f"{len(checks.failures)} failures")
    sys.exit(1 if checks.failures else 0)

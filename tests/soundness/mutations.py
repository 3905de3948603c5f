#!/usr/bin/env python3
"""Makes the proofs unsound, one line at a time, and expects a test to fail each time.

    tests/soundness/mutations.py BUILD_FOLDER               every mutation, in half an hour
    tests/soundness/mutations.py BUILD_FOLDER --only NAME   those with NAME in their names
    tests/soundness/mutations.py --list                     what there is
    tests/soundness/mutations.py --check                    whether the list fits the sources

Mutations are listed in mutations/*.toml: the name says what is wrong, `text` occurs once in `file`
and is replaced, and a test of `filter` in the GoogleTest binary `target` must fail then. Sources are
copied to BUILD_FOLDER/sources and changed and built there, never here; what BUILD_FOLDER holds
already is built on. First the tests are run without any mutation: all must pass.

Exit status: 0 all are caught, 1 some are not or the list doesn't fit, 2 wrong use.
"""

import argparse
import dataclasses
import os
import pathlib
import re
import shutil
import subprocess
import sys
import time
import tomllib

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
LEFT_OUT = {".git", ".cache", "build", "out"}  # of what is copied
MOST_SECONDS = 100  # of a test


@dataclasses.dataclass(frozen=True)
class Mutation:
    name: str
    file: str
    text: str
    replacement: str
    target: str
    filter: str


def read_mutations():
    mutations = []
    for path in sorted((HERE / "mutations").glob("*.toml")):
        entries = tomllib.loads(path.read_text())["mutation"]
        mutations += [Mutation(**entry) for entry in entries]
    return mutations


def tests_of_repository():
    """Suites and tests as they are written: {("Rounding", "AtTheEnds"), ...}."""
    pattern = re.compile(r"^TEST(?:_F|_P)?\(\s*(\w+),\s*(\w+)\)", re.MULTILINE)
    tests = set()
    for path in (REPOSITORY / "tests").rglob("*_test.cpp"):
        tests.update(pattern.findall(path.read_text()))
    for folder in ("scenes", "stability"):  # Scenes/sections.a_ball
        for path in (REPOSITORY / "tests" / folder).glob("*.toml"):
            rows = re.findall(r'\{ name = "([^"]+)"', path.read_text())
            tests.update((path.stem, re.sub(r"\W", "_", name)) for name in rows or [path.stem])
    return tests


def names_a_test(filter_, tests):
    """Whether each part of a filter, "Balls/Mutations.BoundsAreMoved/*", names a test that exists."""
    for part in filter_.split(":"):
        match = re.fullmatch(r"(?:[\w*]+/)?(\w+)\.(\w+)(?:/[\w*]+)?", part)
        if not match or match.groups() not in tests:
            return False
    return True


def mistake_of(mutation, tests):
    """Why a mutation can't be made, or None."""
    path = REPOSITORY / mutation.file
    if not path.is_file():
        return f"there is no {mutation.file}"
    times = path.read_text().count(mutation.text)
    if times != 1:
        return f"its text occurs {times} times in {mutation.file}"
    before, after = mutation.text.split("\n"), mutation.replacement.split("\n")
    if sum(a != b for a, b in zip(before, after)) != 1 or len(before) != len(after):
        return "it doesn't change one line"
    if not names_a_test(mutation.filter, tests):
        return f"{mutation.filter} names no test"
    return None


def mistakes(mutations):
    tests = tests_of_repository()
    found = [f"{m.name}: {mistake_of(m, tests)}" for m in mutations if mistake_of(m, tests)]
    names = [m.name for m in mutations]
    found += [f"{name}: is there twice" for name in sorted(set(names)) if names.count(name) > 1]
    return found


def copy_if_different(source, target):
    content = source.read_bytes()
    if target.is_file() and target.read_bytes() == content:
        return
    target.parent.mkdir(parents=True, exist_ok=True)
    shutil.copy(source, target)


def copy_sources(folder):
    """Copies what differs, so that little is built again."""
    sources = folder / "sources"
    kept = set()
    for top in REPOSITORY.iterdir():
        if top.name in LEFT_OUT:
            continue
        for path in [top, *top.rglob("*")]:
            if path.is_file() and "__pycache__" not in path.parts:
                copy = sources / path.relative_to(REPOSITORY)
                copy_if_different(path, copy)
                kept.add(copy)
    for path in sources.rglob("*"):
        if path.is_file() and path not in kept:
            path.unlink()
    return sources


def configure(folder, sources):
    command = ["cmake", "-S", sources, "-B", folder / "build", "-G", "Ninja",
               "-DCMAKE_BUILD_TYPE=Release", "-DCMAKE_UNITY_BUILD=ON"]
    if shutil.which("ccache"):
        command += [f"-DCMAKE_{language}_COMPILER_LAUNCHER=ccache" for language in ("C", "CXX")]
    subprocess.run(command, check=True, stdout=subprocess.DEVNULL)


def build(folder, targets):
    """The compiler's words if it fails, else None."""
    command = ["cmake", "--build", folder / "build", "--target", *targets]
    done = subprocess.run(command, capture_output=True, text=True)
    return done.stdout + done.stderr if done.returncode != 0 else None


def binary_of(folder, target):
    found = [path for path in (folder / "build" / "tests").rglob(target) if path.is_file()]
    if len(found) != 1:
        sys.exit(f"{len(found)} programs are called {target}")
    return found[0]


def run_tests(folder, target, filter_):
    """passes, fails, hangs, or "runs nothing"."""
    command = [binary_of(folder, target), f"--gtest_filter={filter_}"]
    try:
        done = subprocess.run(command, capture_output=True, text=True, errors="replace",
                              timeout=MOST_SECONDS,
                              env=os.environ | {"ISOMOTION_DATA": str(folder / "sources"),
                                                "ISOMOTION_THOROUGH": "1"})
    except subprocess.TimeoutExpired:
        return "hangs"
    if done.returncode != 0:
        return "fails"
    return "runs nothing" if "[       OK ]" not in done.stdout else "passes"


def check_unmutated(folder, mutations):
    """Builds all targets; the filters that don't pass."""
    words = build(folder, sorted({m.target for m in mutations}))
    if words is not None:
        return [f"the sources as they are don't build:\n{words}"]
    found = []
    for target, filter_ in sorted({(m.target, m.filter) for m in mutations}):
        answer = run_tests(folder, target, filter_)
        if answer != "passes":
            found.append(f"{target} --gtest_filter={filter_}: {answer} without any mutation")
    return found


def verdict_on(mutation, folder, sources):
    path = sources / mutation.file
    original = path.read_text()
    path.write_text(original.replace(mutation.text, mutation.replacement))
    try:
        if build(folder, [mutation.target]) is not None:
            return "does not build"
        answer = run_tests(folder, mutation.target, mutation.filter)
        return "caught" if answer == "fails" else f"NOT caught, its test {answer}"
    finally:
        path.write_text(original)


def is_of_header(mutation):
    """Those come last: after them most is built again, once more."""
    return mutation.file.endswith(".h")


def try_all(folder, mutations):
    """How many are not caught."""
    sources = copy_sources(folder)
    configure(folder, sources)
    wrong = check_unmutated(folder, mutations)
    for line in wrong:
        print(line)
    if wrong:
        return len(wrong)
    caught = 0
    for mutation in sorted(mutations, key=is_of_header):
        begin = time.monotonic()
        verdict = verdict_on(mutation, folder, sources)
        caught += verdict == "caught"
        took = time.monotonic() - begin
        print(f"{verdict}: {mutation.name} ({mutation.filter}, {took:.0f} s)", flush=True)
    print(f"{caught} of {len(mutations)} are caught")
    return len(mutations) - caught


def print_list(mutations):
    for m in mutations:
        print(f"{m.name}\n    {m.file}\n    {m.target} --gtest_filter={m.filter}")
    print(f"{len(mutations)} mutations")


def is_among_sources(folder):
    if REPOSITORY.is_relative_to(folder):
        return True
    return folder.is_relative_to(REPOSITORY) and folder.relative_to(REPOSITORY).parts[0] not in LEFT_OUT


def parse_arguments():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("build_folder", nargs="?", type=pathlib.Path, metavar="BUILD_FOLDER")
    parser.add_argument("--only", metavar="NAME", default="")
    parser.add_argument("--list", action="store_true")
    parser.add_argument("--check", action="store_true")
    arguments = parser.parse_args()
    if not (arguments.list or arguments.check or arguments.build_folder):
        parser.error("name a folder to build in")
    if arguments.build_folder and is_among_sources(arguments.build_folder.resolve()):
        parser.error("the folder to build in is among the sources; build/mutations is not")
    return parser, arguments


def main():
    parser, arguments = parse_arguments()
    mutations = [m for m in read_mutations() if arguments.only in m.name]
    if not mutations:
        parser.error(f"no mutation has '{arguments.only}' in its name")
    if arguments.list:
        print_list(mutations)
        return 0
    wrong = mistakes(mutations)
    for line in wrong:
        print(line)
    if wrong or arguments.check:
        return 1 if wrong else 0
    return 1 if try_all(arguments.build_folder.resolve(), mutations) else 0


if __name__ == "__main__":
    sys.exit(main())

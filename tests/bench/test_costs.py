#!/usr/bin/env python3
"""The processor time of each entry of ctest, the dearest first: what makes the suite slow.

    tests/bench/test_costs.py [CTEST_OPTION]...

Options select entries as ctest's do; without any, those of tools/test. Entries run one after the other, in the
order and with the environment that ctest gives them. ctest itself tells the time by the clock, which other work
on the machine makes longer.
"""
import json
import os
import signal
import subprocess
import sys
from pathlib import Path

root = Path(__file__).resolve().parents[2]


def entries(options):
    told = subprocess.run(["ctest", "--preset", "release", "--show-only=json-v1", *options], cwd=root, check=True,
                          capture_output=True, text=True).stdout
    return json.loads(told)["tests"]


def environment_of(properties):
    """What an entry's ENVIRONMENT and ENVIRONMENT_MODIFICATION make of this program's."""
    environment = dict(os.environ)
    for pair in properties.get("ENVIRONMENT", []):
        name, _, value = pair.partition("=")
        environment[name] = value
    for change in properties.get("ENVIRONMENT_MODIFICATION", []):
        name, _, operation = change.partition("=")
        kind, _, value = operation.partition(":")
        if kind != "set":
            raise SystemExit(f"{change}: only set: is known")
        environment[name] = value
    return environment


def cost(entry):
    """Processor seconds of the entry and of what it starts, and whether it passed or was skipped."""
    properties = {p["name"]: p["value"] for p in entry["properties"]}
    before = os.times()
    ended = subprocess.run(entry["command"], cwd=properties["WORKING_DIRECTORY"], env=environment_of(properties),
                           stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    after = os.times()
    passed = ended.returncode in (0, properties.get("SKIP_RETURN_CODE"))
    return after.children_user + after.children_system - before.children_user - before.children_system, passed


def main():
    signal.signal(signal.SIGTERM, lambda *_: sys.exit(1))
    costs = []
    try:
        for entry in entries(sys.argv[1:] or ["-LE", "exhaustive"]):
            if "command" not in entry:
                raise SystemExit(f"{entry['name']} is not built")
            seconds, passed = cost(entry)
            costs.append((seconds, entry["name"] + ("" if passed else " FAILED")))
            print(f"{len(costs)} {entry['name']}", end="\033[K\r", file=sys.stderr, flush=True)
    except KeyboardInterrupt:
        print("interrupted: the entries so far", file=sys.stderr)
    finally:
        tell(costs)


def tell(costs):
    for seconds, name in sorted(costs, reverse=True):
        print(f"{seconds:7.1f} {name}")
    print(f"{sum(seconds for seconds, _ in costs):7.1f} all {len(costs)}")


if __name__ == "__main__":
    main()

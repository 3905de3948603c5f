#!/usr/bin/env python3
"""What `isomotion accuracy` measured of a scene, on its page: the report that lies beside the scene, one
that is named, and those that are of no use.

    report_test.py PROGRAM
"""
import json
import os

import pages

SCENE = """title = "{title}"
[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1"
bounds = {{ sphere = 1.5 }}
"""


def scene(folder, name, title="A ring"):
    file = os.path.join(folder, name)
    with open(file, "w") as text:
        text.write(SCENE.format(title=title))
    return file


def told(driven, file):
    """What the panel says of accuracy; None where it says nothing."""
    page = driven.page(64, 64)
    page.open(file, "?play=0")
    page.until_at_rest()
    found = page.evaluate("document.getElementById('accuracy').hidden ? null : "
                          "document.querySelector('#accuracy p').textContent")
    page.close()
    return found


def written(given, folder, scene_name, *more):
    """A page of the scene, and what was warned of."""
    file = os.path.join(folder, "page.html")
    ending = pages.run(given.program, "page", scene_name, "-o", file, "--quiet", *more,
                       folder=folder)
    return ending, file


def test(given, folder, driven, checks):
    scene(folder, "ring.toml")
    ending, file = written(given, folder, "ring.toml")
    checks.equal((ending.returncode, ending.stderr), (0, ""), "a page without a report")
    checks.equal(told(driven, file), None, "what a page without a report says")

    measured = pages.run(given.program, "accuracy", "ring.toml", "--size", "24x24", "-o",
                         "ring.accuracy", folder=folder)
    checks.equal(measured.returncode, 0, f"accuracy: {measured.stderr}")
    with open(os.path.join(folder, "ring.accuracy", "accuracy.json")) as report:
        measured = json.load(report)
    own = [row for row in measured["measurements"]
           if row["method"] == "hermite" and row["thresholds"] == 1]
    checks.expect(own, "the report has the scene's own method")
    ending, file = written(given, folder, "ring.toml")
    checks.equal((ending.returncode, ending.stderr), (0, ""), "a page beside a report")
    said = told(driven, file) or ""
    checks.expect(any(said.startswith(f"{row['wrong_ppm']:.3g} wrong pixels in a million, "
                                      f"{row['ms']:.3g} ms") for row in own),
                  f"the page says: {said}, not what was measured: {own}")
    checks.expect("24 x 24" in said and measured["machine"] in said, f"where it was: {said}")

    # A report of another scene: beside, it is left out and told of; named, it is refused.
    scene(folder, "other.toml", "Another ring")
    os.rename(os.path.join(folder, "ring.accuracy"), os.path.join(folder, "other.accuracy"))
    ending, file = written(given, folder, "other.toml")
    checks.equal(ending.returncode, 0, f"a page beside a report of another scene: {ending.stderr}")
    checks.expect("the report is of 'A ring', not of 'Another ring'" in ending.stderr and
                  "without the report" in ending.stderr, f"the warning: {ending.stderr}")
    checks.equal(told(driven, file), None, "what a page beside another's report says")
    ending, _ = written(given, folder, "other.toml", "--accuracy", "other.accuracy")
    checks.equal(ending.returncode, 2, f"a report of another scene, named: {ending.stderr}")
    ending, file = written(given, folder, "ring.toml", "--accuracy", "other.accuracy")
    checks.equal(told(driven, file), said, "what a page of a named report says")

    # Broken ones.
    with open(os.path.join(folder, "other.accuracy", "accuracy.json"), "w") as report:
        report.write('{"scene": "Another ring", "width": "wide"}')
    ending, _ = written(given, folder, "other.toml")
    checks.equal(ending.returncode, 0, f"a page beside a broken report: {ending.stderr}")
    checks.expect("accuracy.json" in ending.stderr, f"the warning: {ending.stderr}")
    ending, _ = written(given, folder, "other.toml", "--accuracy", "none.accuracy")
    checks.expect(ending.returncode in (2, 3), f"a report that is not there: {ending.returncode}")


if __name__ == "__main__":
    pages.main(test)

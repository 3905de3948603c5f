#!/usr/bin/env python3
"""Scenes that would break out of a page, and scenes that no page can show.

    hostile_test.py PROGRAM
"""
import os

import pages

TITLE = """</script><script>window.broken = 1</script> "a" 'b' & <!-- {{data}} ]]> \\u2028"""
SPHERE = """title = {title}
[time]
fps = 30
frames = {frames}
[surface]
formula = "{formula}"
bounds = {{ sphere = 2 }}
{more}
"""


def scene(folder, name, title="a", formula="x^2 + y^2 + z^2 - 1", frames=1, more=""):
    file = os.path.join(folder, name)
    quoted = '"' + title.replace("\\", "\\\\").replace('"', '\\"') + '"'
    with open(file, "w") as text:
        text.write(SPHERE.format(title=quoted, formula=formula, frames=frames, more=more))
    return file


def stays_inside(given, folder, driven, checks):
    more = "# </script></pre><img src=x onerror='window.broken = 2'> <!-- " + TITLE
    file = pages.made(given.program, scene(folder, "t.toml", TITLE, more=more),
                      os.path.join(folder, "t.html"))
    page = driven.page(64, 64)
    page.open(file)
    page.until_at_rest()
    checks.equal(page.evaluate("document.title"), TITLE, "the title")
    checks.equal(page.evaluate("document.querySelector('h1').textContent"), TITLE, "the heading")
    checks.expect(more in page.evaluate("document.getElementById('source').textContent"),
                  "the source is shown as it is")
    checks.equal(page.evaluate("window.broken ?? 0"), 0, "what a title ran")
    checks.equal(page.console, [], "the console")
    page.close()


def names_with_meaning(given, folder, driven, checks):
    """Parameters by the names that the page's own objects and addresses use."""
    names = ["f", "az", "d", "constructor", "toString", "value"]
    formula = " + ".join(["x^2 + y^2 + z^2 - 1"] + [f"0.001*{name}" for name in names])
    more = "[parameters]\n" + "".join(f"{name} = {k}\n" for k, name in enumerate(names))
    file = pages.made(given.program, scene(folder, "n.toml", formula=formula, more=more),
                      os.path.join(folder, "n.html"))
    page = driven.page(64, 64)
    page.open(file, "", "#f=1&p.f=3&constructor=2")
    page.until_at_rest()
    checks.equal(page.evaluate("[...isomotion.look.values].sort()"),
                 [["constructor", 2], ["f", 3]], "the values of a link")
    checks.equal(page.evaluate("isomotion.look.address()"), "#f=1&constructor=2&p.f=3",
                 "the address of such parameters")
    checks.equal(page.console, [], "the console")
    page.close()


def is_refused(given, folder, checks, file, *words, more=()):
    output = os.path.join(folder, "refused.html")
    ending = pages.run(given.program, "page", file, "-o", output, *more)
    checks.equal(ending.returncode, 2, f"the exit code for {os.path.basename(file)}")
    for word in words:
        checks.expect(word in ending.stderr, f"'{word}' in: {ending.stderr}")
    checks.expect(not os.path.exists(output), "nothing is written")


def refusals(given, folder, checks):
    balls = "sum(b, exp(-9*((x-cx)^2 + y^2 + z^2))) - 1"
    is_refused(given, folder, checks, scene(folder, "many.toml", formula=balls, more=
               "[arrays.b]\ncount = 30000\ncx = 'i'"), "many.toml:9: arrays.b.count: ",
               "30000 elements", "at most 20000")
    # No kernels of a distance: they cannot be found by place.
    is_refused(given, folder, checks, scene(folder, "all.toml",
               formula="sum(b, sin(x*cx)*sin(y*z)) - 1", more=
               "[arrays.b]\ncount = 5000\ncx = 'i'"), "all.toml:9: arrays.b.count: ",
               "5000 elements", "at most 1000")
    is_refused(given, folder, checks, scene(folder, "much.toml", formula=balls, frames=25000, more=
               "[arrays.b]\ncount = 1000\ncx = 'i + t'"), "much.toml: ", "MB", "at most 32")
    is_refused(given, folder, checks, scene(folder, "glow.toml", more="[glow]\nstrength = 1"),
               "glow.toml:", "glow: unknown key")
    is_refused(given, folder, checks, scene(folder, "quotes.toml", formula="x^2 - '1'"),
               "quotes.toml:6: surface.formula")
    is_refused(given, folder, checks, os.path.join(folder, "none.toml"), "none.toml")
    is_refused(given, folder, checks, scene(folder, "back.toml"), "unknown back end 'foo'",
               more=["--backend", "foo"])
    both = pages.run(given.program, "page", "torus", "--gallery", folder=folder)
    checks.equal(both.returncode, 2, "a scene and the gallery")
    neither = pages.run(given.program, "page", folder=folder)
    checks.equal(neither.returncode, 2, "neither a scene nor the gallery")
    nowhere = pages.run(given.program, "page", "torus", "-o", "/proc/none/a.html")
    checks.equal(nowhere.returncode, 3, f"a place that cannot be written: {nowhere.stderr}")


def test(given, folder, driven, checks):
    refusals(given, folder, checks)
    stays_inside(given, folder, driven, checks)
    names_with_meaning(given, folder, driven, checks)


if __name__ == "__main__":
    pages.main(test)

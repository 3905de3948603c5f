#!/usr/bin/env python3
"""The whole gallery as a folder of pages: all open, show something and say nothing on the console.

    gallery_test.py PROGRAM
"""
import os
import re

import pages
import png


def shows_something(picture):
    """A picture of a surface has more than a few colours."""
    return len({picture.at(x, y) for y in range(0, picture.height, 3)
                for x in range(0, picture.width, 3)}) > 20


def test(given, folder, driven, checks):
    site = os.path.join(folder, "site")
    ending = pages.run(given.program, "page", "--gallery", "-o", site, "--quiet", seconds=1200)
    checks.equal(ending.returncode, 0, f"page --gallery: {ending.stderr}")
    with open(os.path.join(site, "index.html")) as index:
        text = index.read()
    names = re.findall(r'href="\./([^"]*)\.html"', text)
    checks.expect("/animations/" not in text, "the index tells where its scenes lie")
    listed = pages.run(given.program, "list", "animations").stdout.splitlines()
    known = {line.split()[0] for line in listed if line.strip()}
    # Glass among several surfaces is the only thing that a page refuses of the gallery.
    refused = re.findall(r"left out: (\w+): .*: [\w.]*material.transmission: "
                         r"a page shows glass of one", ending.stderr)
    checks.equal(len(refused), ending.stderr.count("left out: "), f"left out: {ending.stderr}")
    checks.equal({*names, *refused}, known, f"pages of animations: {ending.stderr}")
    index = driven.page(360, 640)
    index.call("Page.navigate", url="file://" + os.path.join(site, "index.html"))
    index.until("document.readyState === 'complete'")
    checks.equal(index.evaluate("document.documentElement.scrollWidth"), 360, "the index's width")
    checks.equal(index.evaluate("[...document.images].filter((image) => image.complete && "
                                "image.naturalWidth !== 256).length"), 0, "posters that are missing")
    index.close()
    for name in names:
        page = driven.page(192, 192)
        page.open(os.path.join(site, name + ".html"), "?ui=0&samples=1&play=0")
        page.until_at_rest()
        failure = page.evaluate("document.getElementById('failure').textContent")
        checks.equal((failure, page.console), ("", []), name)
        checks.expect(shows_something(png.read(page.screenshot())), f"{name} shows something")
        page.close()


if __name__ == "__main__":
    pages.main(test)

#!/usr/bin/env python3
"""A page is one small file that loads nothing, and never says that a picture is proved.

    alone_test.py PROGRAM
"""
import os

import pages

MOST_BYTES = 300_000  # of blobby75's
CERTIFIED = """title = "Certified"
[surface]
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.5 }
[isolation]
certify = true
"""
VISIBLE = """[...document.querySelectorAll("body *:not(script):not(style):not(#source)")]
    .flatMap((of) => [...of.childNodes].filter((node) => node.nodeType === Node.TEXT_NODE)
        .map((node) => node.data).concat(of.title, of.getAttribute("aria-label")))
    .filter((text) => text?.trim?.()).join("\\n")"""


def loads_nothing(driven, file, checks):
    """Also while it plays, refines and copies a link."""
    page = driven.page(360, 640)
    asked = page.listen("Network.requestWillBeSent", "Network.enable")
    page.open(file, "?play=0&samples=2")
    page.until_at_rest()
    page.press(" ", "Space")
    page.until("isomotion.painter.drawn > 4", 60)
    page.press("c")
    addresses = {message["request"]["url"].split("?")[0].split("#")[0] for message in asked}
    own = "file://" + os.path.abspath(file)
    checks.expect(own in addresses, f"{own} in {addresses}")
    others = {address for address in addresses - {own} if not address.startswith("data:,")}
    checks.equal(others - {"about:blank"}, set(), "what a page asks for beside itself")
    checks.equal(page.evaluate("performance.getEntriesByType('resource').length"), 0,
                 "resources that were loaded")
    checks.equal(page.console, [], "the console")
    page.close()


def proves_nothing(given, folder, driven, checks):
    scene = os.path.join(folder, "certified.toml")
    with open(scene, "w") as text:
        text.write(CERTIFIED)
    page = driven.page()
    page.open(pages.made(given.program, scene, os.path.join(folder, "certified.html")))
    page.until_at_rest()
    told = page.evaluate(VISIBLE)
    checks.expect("Certified" in told and "Formula" in told, f"what a page says: {told}")
    for word in ("proved", "proven", "certif"):
        checks.expect(word not in told.replace("Certified", ""), f"{word} in {told}")
    page.close()


def test(given, folder, driven, checks):
    file = pages.made(given.program, "blobby75", os.path.join(folder, "blobby75.html"))
    size = os.path.getsize(file)
    print(f"blobby75: {size} bytes")
    checks.expect(size < MOST_BYTES, f"blobby75's page has {size} bytes")
    loads_nothing(driven, file, checks)
    proves_nothing(given, folder, driven, checks)


if __name__ == "__main__":
    pages.main(test)

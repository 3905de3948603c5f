#!/usr/bin/env python3
"""What is on the screen: small pictures first and while something moves, whole ones at rest; text that
can be read on a phone; what a page says where memory is missing.

    screen_test.py PROGRAM
"""
import os

import pages

SCENE = """title = "A ring of a long name that no phone has room for in one line, whatever it does"
[time]
fps = 30
frames = 60
[surface]
formula = "(sqrt(x^2 + y^2) - R)^2 + z^2 - a^2"
bounds = { sphere = 1.6 }
[parameters]
R = "1 + 0.1*sin(t)"
a = 0.3
"""
# Notes each picture that is shown: its width, how many were summed up, and whether it plays.
NOTES = """window.noted = [];
let own;
Object.defineProperty(window, "isomotion", { get: () => own, set: (value) => {
    own = value;
    const { painter } = own, { shown } = painter.listeners;
    painter.listeners.shown = (state) => {
        noted.push({ ...state, playing: own.look.playing });
        shown(state);
    };
} });"""


def refines(driven, file, checks):
    page = driven.page(200, 200)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=NOTES)
    page.open(file, "?ui=0&play=0", "#f=7")
    page.until_at_rest()
    shown = page.evaluate("noted")
    first, whole = shown[0], shown[1:]
    checks.equal((first["width"], first["samples"]), (50, 1), "the first picture of all")
    checks.equal([(one["width"], one["samples"]) for one in whole],
                 [(200, k) for k in range(1, 17)], "pictures at rest")
    checks.equal({one["frame"] for one in shown}, {7}, "frames at rest")
    # A scale that this machine may not need.
    page.evaluate("""noted.length = 0;
        isomotion.painter.resolution.measured = () => undefined;
        isomotion.painter.resolution.choose(8);
        isomotion.commands[' ']()""")
    page.until("noted.filter((one) => one.playing).length > 3", 60)
    page.evaluate("isomotion.commands[' ']()")
    page.until_at_rest()
    shown = page.evaluate("noted")
    moving = [one for one in shown if one["playing"]]
    checks.equal({(one["width"], one["samples"]) for one in moving}, {(50, 1)}, "pictures that move")
    checks.equal((shown[-1]["width"], shown[-1]["samples"]), (200, 16), "the last picture at rest")
    checks.equal(page.console, [], "the console")
    page.close()


# For each text that is seen: what it is, how large it is, and where it ends to the right.
TEXTS = """[...document.querySelectorAll("body *")].filter((of) => of.checkVisibility() &&
    [...of.childNodes].some((node) => node.nodeType === Node.TEXT_NODE && node.data.trim())).map((of) =>
    [of.tagName + "#" + of.id, parseFloat(getComputedStyle(of).fontSize),
     of.getBoundingClientRect().right])"""


def reads_on_a_phone(driven, file, checks):
    page = driven.page(360, 640, touch=True)
    page.open(file, "?play=0&samples=1")
    page.until_at_rest()
    for opened in (False, True):
        if opened:
            page.press("?")
        texts = page.evaluate(TEXTS)
        checks.expect(len(texts) > (15 if opened else 1), f"texts of a phone: {texts}")
        small = [one for one in texts if one[1] < 12]
        checks.equal(small, [], f"text of less than 12 px, about {opened}")
        cut = [one for one in texts if one[2] > 360.5 and not one[0].startswith("PRE")]
        checks.equal(cut, [], f"text beyond the screen, about {opened}")
        checks.equal(page.evaluate("document.documentElement.scrollWidth"), 360, "the width")
    small = page.evaluate("""[...document.querySelectorAll("button")].filter((of) => of.checkVisibility())
        .map((of) => [of.id + of.className, of.getBoundingClientRect().width,
                      of.getBoundingClientRect().height])
        .filter(([, width, height]) => width < 32 || height < 32)""")
    checks.equal(small, [], "buttons too small for a finger")
    page.close()


NO_MEMORY = """WebGL2RenderingContext.prototype.checkFramebufferStatus = function () {
    return this.FRAMEBUFFER_UNSUPPORTED;
}"""


def needs_memory(driven, file, checks):
    page = driven.page(200, 200)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=NO_MEMORY)
    page.open(file)
    page.until("!document.getElementById('failure').hidden", 20)
    told = page.evaluate("document.getElementById('failure').textContent")
    checks.expect("too little memory for float textures" in told, f"without memory: {told}")
    page.close()


def test(given, folder, driven, checks):
    scene = os.path.join(folder, "ring.toml")
    with open(scene, "w") as text:
        text.write(SCENE)
    file = pages.made(given.program, scene, os.path.join(folder, "ring.html"))
    refines(driven, file, checks)
    reads_on_a_phone(driven, file, checks)
    needs_memory(driven, file, checks)


if __name__ == "__main__":
    pages.main(test)

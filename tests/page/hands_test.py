#!/usr/bin/env python3
"""A page under a person's hands, end to end: play, scrub, events, drag, wheel, keys, sliders, links;
what it does where the page is hidden and where the graphics card is reset.

    hands_test.py PROGRAM
"""
import os
import time

import pages
import png

SCENE = """title = "Two balls"
[time]
fps = 30
frames = 90
[surface]
formula = "exp(-a*((x-d)^2 + y^2 + z^2)) + exp(-a*((x+d)^2 + y^2 + z^2)) - 0.5"
bounds = { sphere = 3 }
[parameters]
a = 2
d = "1.1 - 0.3*t"
[material]
color = [0.7, 0.3, 0.1]
"""


def look(page):
    return page.evaluate("""(() => {
        const { look } = isomotion, frame = look.frame(performance.now() / 1000);
        return { frame, playing: look.playing, view: look.view(frame),
                 held: look.camera !== undefined };
    })()""")


def picture(page):
    page.until_at_rest()
    return png.read(page.screenshot())


def plays(page, checks):
    page.until_at_rest()
    before = page.evaluate("isomotion.painter.drawn")
    time.sleep(0.6)
    checks.equal(page.evaluate("isomotion.painter.drawn"), before, "pictures drawn at rest")
    page.evaluate("document.getElementById('play').click()")
    page.until("isomotion.look.frame(performance.now() / 1000) > 12", 30)
    checks.equal(look(page)["playing"], True, "playing")
    page.until(f"isomotion.painter.drawn > {before}", 30)
    page.press(" ", "Space")
    checks.equal(look(page)["playing"], False, "playing after Space on the play button")


def scrubs(page, checks):
    page.evaluate("""(() => { const frame = document.getElementById('frame');
        frame.value = 44; frame.dispatchEvent(new Event('input')); frame.blur(); })()""")
    checks.equal(look(page)["frame"], 44, "frame scrubbed to")
    page.press("ArrowRight")
    checks.equal(look(page)["frame"], 45, "frame after an arrow")
    page.press("Home")
    checks.equal(look(page)["frame"], 1, "frame after Home")
    page.press("End")
    checks.equal(look(page)["frame"], 90, "frame after End")
    page.until_at_rest()
    checks.equal(page.evaluate("document.getElementById('frame-number').textContent"), "90 / 90",
                 "the frame's number")


def goes_to_events(page, checks):
    marks = page.evaluate("""[...document.querySelectorAll('.mark')].map((mark) => mark.title)""")
    checks.equal(len(marks), 1, f"marks of events {marks}")
    checks.expect(any("merge" in mark for mark in marks), f"marks say what merges: {marks}")
    checks.expect(not any("proved" in mark for mark in marks), f"marks never say proved: {marks}")
    page.evaluate("document.querySelector('.mark')?.click()")
    frame = look(page)["frame"]
    checks.expect(1 < frame < 90, f"an event's frame: {frame}")


def turns(page, checks):
    before = look(page)
    page.drag((150, 200), (230, 170))
    turned = look(page)
    checks.equal((before["held"], turned["held"]), (False, True), "held cameras")
    size = lambda v: sum(c * c for c in v) ** 0.5
    apart = lambda v, w: size([a - b for a, b in zip(v, w)])
    away = lambda l: apart(l["view"]["position"], l["view"]["target"])
    checks.expect(apart(before["view"]["position"], turned["view"]["position"]) > 0.5, "a drag turns")
    checks.expect(abs(away(before) / away(turned) - 1) < 1e-9, "a drag keeps the distance")
    page.mouse("mouseWheel", 200, 200, deltaX=0, deltaY=-240)
    near = look(page)
    checks.expect(away(near) < 0.8 * away(turned), "the wheel comes nearer")
    page.press("f")
    checks.expect(away(look(page)) > away(near), "F fits the bounds")
    page.press("r")
    checks.equal(look(page)["held"], False, "held after R")


def changes_speed(page, checks):
    told = lambda: (page.evaluate("isomotion.look.playback.doublings"),
                    page.evaluate("document.getElementById('speed').textContent"))
    checks.equal(told(), (0, ""), "the speed at first")
    steps = []
    for key in "[" * 4 + "]" * 8 + "[" * 3:
        page.press(key)
        steps.append(told())
    slow, fast = [(-1, "1/2 ×"), (-2, "1/4 ×"), (-3, "1/8 ×")], [(1, "2 ×"), (2, "4 ×"), (3, "8 ×")]
    wanted = (slow + slow[-1:] + slow[1::-1] + [(0, "")] + fast + fast[-1:] * 2 + fast[1::-1] +
              [(0, "")])
    checks.equal(steps, wanted, "speeds by [ and ]")
    # Twice as fast, the same frame is on.
    page.evaluate("""isomotion.look.playback = { ...isomotion.look.playback, anchor: 30,
        playing: true, moment: performance.now() / 1000 }""")
    before = look(page)["frame"]
    page.press("]")
    checks.expect(look(page)["frame"] >= before, "another speed does not go back")
    page.press("[")
    page.press(" ", "Space")
    checks.equal(look(page)["playing"], False, "playing after Space")


def loops(page, checks):
    said = lambda: page.evaluate("document.getElementById('said').textContent")
    checks.equal(page.evaluate("isomotion.look.playback.loop"), False, "looping at first")
    page.press("End")
    page.press("ArrowLeft")
    page.press(" ", "Space")
    page.until("!isomotion.look.playing", 30)
    checks.equal(look(page)["frame"], 90, "where it ends")
    page.press("l")
    checks.equal((said(), page.evaluate("isomotion.look.playback.loop")),
                 ("plays over and over", True), "after L")
    page.press(" ", "Space")
    page.until("isomotion.look.frame(performance.now() / 1000) < 45", 30)
    checks.equal(look(page)["playing"], True, "playing after the last frame")
    page.press(" ", "Space")
    page.press("L")
    checks.equal((said(), page.evaluate("isomotion.look.playback.loop")), ("plays once", False),
                 "after another L")


def opens(page, checks):
    is_open = lambda: page.evaluate("document.getElementById('about').classList.contains('open')")
    keys = lambda: page.evaluate("document.getElementById('keys').open")
    shows = lambda: page.evaluate(
        "document.getElementById('formula').getBoundingClientRect().height > 0")
    checks.equal((is_open(), shows()), (False, False), "what stands beside the picture")
    page.press("p")
    checks.equal((is_open(), shows(), keys()), (True, True, False), "after P")
    page.press("p")
    checks.equal((is_open(), shows()), (False, False), "after another P")
    page.press("?")
    checks.equal((is_open(), keys()), (True, True), "after ?")
    told = page.evaluate("document.getElementById('keys').textContent")
    for key in "[", "]", "L", "D", "P", "?", "F", "R", "C":
        checks.expect(key in told, f"{key} in {told}")
    page.press("Escape")
    checks.equal((is_open(), shows()), (False, False), "after Escape")


def brightness(color):
    """Relative luminance (WCAG 2), of red, green and blue up to 255."""
    linear = [c / 255 / 12.92 if c <= 10 else ((c / 255 + 0.055) / 1.055) ** 2.4 for c in color]
    return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]


def contrast(a, b):
    low, high = sorted((brightness(a), brightness(b)))
    return (high + 0.05) / (low + 0.05)


COLORS = """["h1", "#frame-number", "#formula", ".slider span", "#keys"].map((name) => {
    const color = (text) => text.match(/[0-9.]+/g).slice(0, 3).map(Number);
    const of = document.querySelector(name);
    let behind = of, paper;
    do {
        paper = getComputedStyle(behind).backgroundColor;
        behind = behind.parentElement;
    } while (paper === "rgba(0, 0, 0, 0)" && behind);
    return [name, color(getComputedStyle(of).color), color(paper)];
})"""


def is_dark(driven, file, checks):
    """Light or dark as the system has it, and by D the other; the picture stays."""
    pictures = []
    for dark in (False, True):
        page = driven.page(500, 400, dark=dark)
        page.open(file, "?play=0", "#f=40")
        page.press("p")
        for is_dark_now in (dark, not dark):
            shown = picture(page)
            corner = shown.at(3, 3)
            checks.equal(brightness(corner) < 0.2, is_dark_now, f"dark paper: {corner}")
            for name, ink, paper in page.evaluate(COLORS):
                ratio = contrast(ink, paper)
                checks.equal(brightness(paper) < 0.2, is_dark_now, f"dark paper of {name}: {paper}")
                checks.expect(ratio >= 4.5, f"{name}, dark {is_dark_now}: contrast {ratio:.1f}")
            place = page.evaluate("""(() => { const { left, top, width, height } =
                isomotion.painter.canvas.getBoundingClientRect();
                return [left, top, width, height].map(Math.round); })()""")
            left, top, width, height = place
            pictures.append([shown.at(x, y) for y in range(top, top + height, 3)
                             for x in range(left, left + width, 3)])
            page.press("d")
        checks.equal(page.console, [], "the console")
        page.close()
    checks.expect(all(one == pictures[0] for one in pictures), "pictures do not follow the theme")
    checks.expect(len(set(pictures[0])) > 20, "pictures show something")


def pinches(driven, file, checks):
    page = driven.page(360, 640, touch=True)
    page.open(file, "?play=0", "#f=1")
    page.until_at_rest()
    before = look(page)
    touch = lambda kind, *points: page.call("Input.dispatchTouchEvent", type=kind, touchPoints=[
        {"x": x, "y": y, "id": k} for k, (x, y) in enumerate(points)])
    touch("touchStart", (160, 250))
    touch("touchStart", (160, 250), (200, 250))
    for k in range(1, 5):
        touch("touchMove", (160 - 10 * k, 250), (200 + 10 * k, 250))
    touch("touchEnd")
    after = look(page)
    distance = lambda l: sum((a - b) ** 2 for a, b in
                             zip(l["view"]["position"], l["view"]["target"])) ** 0.5
    ratio = distance(before) / distance(after)
    checks.expect(2 < ratio < 4, f"fingers three times as far apart come {ratio} times as near")
    wide = page.evaluate("document.documentElement.scrollWidth")
    checks.equal(wide, 360, "width of what a phone shows")
    page.close()


def slides(page, checks):
    before = picture(page)
    page.evaluate("""(() => { document.getElementById('about').classList.add('open');
        const slider = document.querySelector('.slider input');
        slider.value = 4; slider.dispatchEvent(new Event('input')); })()""")
    page.evaluate("document.getElementById('about').classList.remove('open')")
    checks.equal(page.evaluate("[...isomotion.look.values]"), [["a", 4]], "values held")
    after = picture(page)
    checks.expect(before.rows != after.rows, "a slider changes the picture")


def links(driven, page, file, checks):
    """A link that was copied and opened shows the same picture."""
    page.drag((150, 200), (100, 260))
    page.until_at_rest()
    page.press("c")
    fragment = page.evaluate("location.hash")
    checks.expect("az=" in fragment and "a=4" in fragment, f"the link {fragment}")
    page.until("document.getElementById('said').textContent === ''", 10)
    shown = picture(page)
    other = driven.page(500, 400)
    other.open(file, "?play=0", fragment)
    again = picture(other)
    differing = png.differences(shown, again)[0]
    checks.expect(differing <= 20, f"a link's picture differs in {differing} pixels")
    # Nonsense in a link is left out.
    other.open(file, "?play=0", "#f=1e99&az=x&el=&d=-1&t=a,b&a=NaN&toString=1&%zz")
    other.until_at_rest()
    checks.equal(look(other)["frame"], 90, "the frame of a link beyond the last")
    checks.equal(look(other)["held"], False, "the camera of a link of nonsense")
    checks.equal(other.console, [], "the console after nonsense")
    other.close()
    page.to_front()


def hides(page, checks):
    # Closing a tab may bring another one to the front, on a busy machine late.
    for _ in range(20):
        page.to_front()
        if not page.evaluate("document.hidden"):
            break
        time.sleep(0.5)
    page.evaluate("document.getElementById('play').click()")
    page.until("isomotion.look.playing")
    page.evaluate("""(() => { Object.defineProperty(document, 'hidden',
        { configurable: true, get: () => true });
        document.dispatchEvent(new Event('visibilitychange')); })()""")
    before = page.evaluate("isomotion.painter.drawn")
    time.sleep(3)
    # The picture on its way comes, on a busy machine late.
    drawn = page.evaluate("isomotion.painter.drawn") - before
    checks.expect(drawn <= 1, f"{drawn} pictures of a hidden page")
    before += drawn
    time.sleep(2)
    checks.equal(page.evaluate("isomotion.painter.drawn"), before, "pictures of a page that is hidden for long")
    page.evaluate("""(() => { delete document.hidden;
        document.dispatchEvent(new Event('visibilitychange')); })()""")
    page.until(f"isomotion.painter.drawn > {before}", 20)
    page.press(" ", "Space")


def is_reset(page, checks):
    """The context is lost and given back."""
    page.press("Home")
    page.evaluate("document.activeElement.blur()")
    page.press("Home")
    before = picture(page)
    page.evaluate("""(() => { window.loses = isomotion.painter.gl.getExtension('WEBGL_lose_context');
        loses.loseContext(); })()""")
    page.until("document.getElementById('waits').textContent !== ''", 20)
    time.sleep(0.3)
    page.evaluate("loses.restoreContext()")
    page.until("document.getElementById('waits').textContent === ''", 60)
    page.until("isomotion.painter.isAtRest", 60)
    checks.equal(page.evaluate("document.getElementById('failure').hidden"), True, "no failure")
    after = picture(page)
    checks.expect(before.rows == after.rows, "after a reset the picture is the same")


def keeps_pace(page, checks):
    """The resolution against pictures of known cost: fixed + filled * s^2 milliseconds."""
    for fixed, filled, low, high in [(2, 10, 0, 0), (5, 200, 5, 8), (20, 4000, 14, 16),
                                     (60, 300, 4, 9)]:
        rung = page.evaluate(f"""(() => {{
            const resolution = new isomotion.painter.resolution.constructor();
            const rungs = [];
            for (let k = 0; k < 300; ++k) {{
                resolution.measured({fixed} + {filled} * resolution.scale ** 2);
                rungs.push(resolution.rung);
            }}
            return rungs.slice(-150).sort((a, b) => a - b)[75];
        }})()""")
        checks.expect(low <= rung <= high, f"{fixed} + {filled} s^2 ms: rung {rung}")


def needs_floats(driven, file, checks):
    """Where the browser lacks something the page says what."""
    for script, word in [
            ("HTMLCanvasElement.prototype.getContext = () => null", "WebGL2"),
            ("WebGL2RenderingContext.prototype.getExtension = () => null", "EXT_color_buffer_float"),
            ("window.DecompressionStream = undefined", "DecompressionStream")]:
        page = driven.page(360, 640)
        page.call("Page.addScriptToEvaluateOnNewDocument", source=script)
        page.open(file)
        page.until("!document.getElementById('failure').hidden", 20)
        told = page.evaluate("document.getElementById('failure').textContent")
        checks.expect(word in told, f"without {word} the page says: {told}")
        page.close()


FOUR_TEXTURES = """{
    const { prototype } = WebGL2RenderingContext, { getParameter } = prototype;
    prototype.getParameter = function (name) {
        return name === this.MAX_DRAW_BUFFERS ? 4 : getParameter.call(this, name);
    };
}"""


def needs_textures(driven, folder, given, checks):
    """Where a browser draws into four textures at once, as WebGL2 promises, 128 elements are drawn,
    and of more the page says what is missing."""
    for animation, told in [("blobby75", ""), ("falling_drops", "draws into 4 textures at once, and "
                                               "this scene needs 7")]:
        file = pages.made(given.program, animation, os.path.join(folder, "textures.html"),
                          "--set", "look=none")
        page = driven.page(64, 64)
        page.call("Page.addScriptToEvaluateOnNewDocument", source=FOUR_TEXTURES)
        page.open(file, "?ui=0&play=0&samples=1")
        page.until("isomotion?.painter.drawn > 0 || !document.getElementById('failure').hidden", 60)
        said = page.evaluate("document.getElementById('failure').textContent").strip()
        checks.expect(told in said if told else not said, f"{animation} with four textures: {said}")
        page.close()


SMALL_TEXTURES = FOUR_TEXTURES.replace("DRAW_BUFFERS ? 4", "TEXTURE_SIZE ? 600")


def needs_large_textures(driven, folder, given, checks):
    """Where textures are too small for lists of elements the page says so, not that memory is."""
    file = pages.made(given.program, "blobby75", os.path.join(folder, "small.html"),
                      "--set", "look=none")
    page = driven.page(64, 64)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=SMALL_TEXTURES)
    page.open(file, "?ui=0&play=0&samples=1")
    page.until("isomotion?.painter.drawn > 0 || !document.getElementById('failure').hidden", 60)
    said = page.evaluate("document.getElementById('failure').textContent").strip()
    checks.expect("at most 600 x 600 pixels, and this scene needs one of 1024 x" in said,
                  f"blobby75 with small textures: {said}")
    checks.expect("memory" not in said, said)
    page.close()


def has_a_movie(driven, folder, scene, given, checks):
    """`--video`: where nothing can be drawn, the movie plays; elsewhere it is not seen."""
    file = pages.made(given.program, scene, os.path.join(folder, "movie.html"), "--video",
                      "--set", "time.frames=5", "--set", "output.size=[64, 64]")
    page = driven.page(360, 640)
    page.open(file)
    page.until("isomotion.painter.drawn > 0", 60)
    checks.equal(page.evaluate("document.getElementById('movie').hidden"), True, "an idle movie")
    page.call("Page.addScriptToEvaluateOnNewDocument",
              source="HTMLCanvasElement.prototype.getContext = () => null")
    page.open(file)
    page.until("!document.getElementById('movie').hidden", 20)
    page.evaluate("document.getElementById('movie').play()")
    page.until("document.getElementById('movie').currentTime > 0", 20)
    page.close()


def is_embedded(driven, folder, file, checks):
    """In a frame's srcdoc, as notebooks show it."""
    outer = os.path.join(folder, "outer.html")
    with open(file) as text:
        inner = text.read().replace("&", "&amp;").replace('"', "&quot;")
    with open(outer, "w") as text:
        text.write(f'<iframe width="300" height="300" srcdoc="{inner}"></iframe>')
    page = driven.page(320, 320)
    page.call("Page.navigate", url="file://" + outer)
    page.until("document.querySelector('iframe')?.contentWindow?.isomotion?.painter.drawn > 0", 60)
    page.evaluate("document.querySelector('iframe').contentWindow.isomotion.commands.c()")
    checks.equal(page.console, [], "the console of a frame")
    page.close()


def test(given, folder, driven, checks):
    scene = os.path.join(folder, "balls.toml")
    with open(scene, "w") as text:
        text.write(SCENE)
    found = pages.run(given.program, "topology", "balls.toml", "-o", "balls.timeline.json",
                      folder=folder)
    checks.expect(found.returncode in (0, 4), f"topology: {found.returncode}: {found.stderr}")
    file = pages.made(given.program, scene, os.path.join(folder, "balls.html"))
    page = driven.page(500, 400)
    page.open(file, "?play=0", "#f=1")
    for part in (plays, scrubs, goes_to_events, turns, changes_speed, loops, opens, slides):
        part(page, checks)
    links(driven, page, file, checks)
    keeps_pace(page, checks)
    hides(page, checks)
    is_reset(page, checks)
    checks.equal([line for line in page.console if "CONTEXT_LOST" not in line], [], "the console")
    page.close()
    is_dark(driven, file, checks)
    pinches(driven, file, checks)
    needs_floats(driven, file, checks)
    needs_textures(driven, folder, given, checks)
    needs_large_textures(driven, folder, given, checks)
    has_a_movie(driven, folder, scene, given, checks)
    is_embedded(driven, folder, file, checks)


if __name__ == "__main__":
    pages.main(test)

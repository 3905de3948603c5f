#!/usr/bin/env python3
"""Frames of pages against `isomotion render`: the same verdicts, the same colours.

    frames_test.py PROGRAM [--all]

Pixels may differ at silhouettes: 20 in a million, of which a picture of 256 x 256 has one or two.
"""
import os

import pages
import png

SIDE = 256
# Scenes of the gallery with the frame looked at, what is changed in them, and what sliders hold.
CAMERA = "camera={position=[6, 4, 3], target=[0, 0, 0], fov=36}"
QUICK = [
    ("blobby75", 40, []),
    ("blobby75_chrome", 40, []),
    ("twisting_superquadric", 16, []),
    ("blobby75", 20, [CAMERA], {"s": 1.45, "R": 0.3}),
]
ALL = QUICK + [
    ("barth_decic", 40, []),
    ("chmutov_14", 1, []),
    ("chmutov_14_trig", 60, []),
    ("chmutov_12_two_lights", 40, []),
    ("evaluations_heat", 40, []),
    ("falling_drops", 55, []),
    ("steiner", 40, []),
    ("superquadric", 7, ['isolation.method="affine"']),
    ("torus", 40, ['isolation.method="amp-taylor"', 'output.background="transparent"']),
    ("falling_drops", 30, [], {"R": 0.06, "a": 120}),
    ("rules.toml", 3, [CAMERA], {"c": 0.7}),
    ("csg.toml", 1, []),
    ("ground.toml", 3, []),
    ("lens.toml", 1, []),
    ("look.toml", 2, []),
    ("look.toml", 2, [CAMERA]),
    ("moved.toml", 2, []),
    ("mirror.toml", 1, []),
]
SCENES = {
    # A cube without a ball, cut by a plane: kinks, two sides.
    "csg.toml": """[time]
frames = 2
[surface]
formula = "max(max(max(abs(x), max(abs(y), abs(z))) - 1, 1.25 - sqrt(x^2 + y^2 + z^2)), x + y - 1.5)"
bounds = { sphere = 2 }
[camera]
azimuth = 30
elevation = 25
[material]
back_color = [0.7, 0.2, 0.1]
""",
    # Parameters, bounds and elements that depend on one another by every function.
    "rules.toml": """[time]
frames = 4
[surface]
formula = "sum(b, exp(-8*w*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - q"
bounds = { box = [["-1.5 - c", -1.7, -1.4], [1.9, "1.2 + d", 1.6]] }
[parameters]
c = "0.2 + 0.1*t"
d = "min(max(abs(-c), sqrt(c)/2), exp(c) - 0.5) + 0.01*floor(3*c) + 0.1*sign(c)"
q = "0.4 + 0.1*sin(d)*cos(t) + 0.02*tan(c/2) + 0.01*tanh(c) + 0.01*log(1 + c) + 0.02*atan(d)"
[arrays.b]
count = 30
w = "0.5 + c^1.5"
u = "random(i, 1) - 0.5"
v = [0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8, 0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8, 0.1, -0.2, 0.3, -0.4, 0.5, -0.6, 0.7, -0.8, 0.1, -0.2, 0.3, -0.4, 0.5, -0.6]
cx = "2*u*(1 + c)"
cy = "v*d*2 + 0.1*sinh(c)*cosh(u) - 0.1*asin(c/2)*acos(c/2)"
cz = "sin(i*d + t)*i/n"
""",
    # Ground, fog, occlusion, a light at a place, no other light.
    "ground.toml": """[time]
frames = 4
[surface]
formula = "x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + c"
bounds = { sphere = 2 }
[parameters]
c = "0.3*sin(t)"
[[lights]]
position = [2, -3, 4]
shadow = true
falloff = 5
[ground]
height = -1
[fog]
density = 0.1
[occlusion]
[material]
model = "blinn-phong"
[output]
background = { top = [0.2, 0.4, 0.8], bottom = [0.9, 0.9, 1] }
""",
    # The mean of pictures through a lens.
    "lens.toml": """[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1"
bounds = { sphere = 1.5 }
[camera]
aperture = 0.3
projection = "perspective"
[output]
samples = 4
""",
    # A look, its lights with the camera and of a size, in a surface that is turned.
    "look.toml": """look = "studio"
[time]
frames = 3
[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1"
transform = { rotate = [20, "30*t", 10], scale = 2, translate = [1, 0, 0] }
[[lights]]
direction = [1, 1, 1]
with_camera = true
shadow = true
radius = 12
[[lights]]
position = [3, -4, 5]
falloff = 4
shadow = true
radius = 0.6
[output]
samples = 4
""",
    # Mirrors that show shadows, and a rough environment.
    "mirror.toml": """[surface]
formula = "min(z + 0.5, x + 1, sqrt((x - 1)^2 + y^2 + (z - 0.2)^2) - 0.4)"
bounds = { sphere = 3 }
[camera]
position = [3, -1, 1]
[[lights]]
direction = [1, 0.2, 0.3]
shadow = true
[environment]
map = "studio.exr"
[material]
model = "ggx"
metallic = 0.5
roughness = 0.3
reflection = "self"
""",
    # A placement far away, parallel rays, no light of its own.
    "moved.toml": """[time]
frames = 3
[surface]
formula = "x^2 + y^2*z + z^2 - 0.5"
bounds = { box = [[-1, -1.2, -1], [1, 1, 1.5]] }
transform = { translate = [1000, 20, -7], rotate = [10, "40*t", 3], scale = 12 }
[camera]
projection = "orthographic"
azimuth = 200
elevation = -20
""",
}


def scene_file(name, folder):
    if name not in SCENES:
        return name
    file = os.path.join(folder, name)
    with open(file, "w") as text:
        text.write(SCENES[name])
    return file


def tally_of(rendered):
    """Rays by verdict, as `render` tells."""
    line = next(line for line in rendered.splitlines() if line.startswith("rays:"))
    return [int(part.split()[0]) for part in line.removeprefix("rays: ").split(", ")]


def compare(given, folder, driven, checks, name, frame, changes, held={}):
    # One picture a frame shows where a pixel differs.
    if not name.endswith(".toml"):
        changes = ["look=none", "output.samples=1", *changes]
    settings = [word for change in changes for word in ("--set", change)]
    scene = scene_file(name, folder)
    file = pages.made(given.program, scene, os.path.join(folder, "page.html"), *settings)
    ending = pages.run(given.program, "render", scene, "--frames", str(frame), "--size",
                       f"{SIDE}x{SIDE}", "--audit", "off", "-o", os.path.join(folder, "r.####.png"),
                       *settings, *[word for name, value in held.items()
                                    for word in ("--set", f"{name}={value}")])
    checks.equal(ending.returncode, 0, f"render {name}: {ending.stderr}")
    with open(os.path.join(folder, f"r.{frame:04}.png"), "rb") as rendered:
        wanted = png.read(rendered.read())
    page = driven.page(SIDE, SIDE)
    samples = 4 if name in ("lens.toml", "look.toml") else 1
    page.open(file, f"?ui=0&tally&samples={samples}",
              f"#f={frame}" + "".join(f"&{name}={value}" for name, value in held.items()))
    page.until_at_rest()
    if 'output.background="transparent"' in changes:
        page.call("Emulation.setDefaultBackgroundColorOverride",
                  color={"r": 0, "g": 0, "b": 0, "a": 0})
        page.evaluate("document.body.style.background = 'transparent'")
    shown = png.read(page.screenshot())
    told = page.evaluate("isomotion.painter.told")
    page.close()
    everywhere, off_edges = png.differences(shown, wanted)
    rays = tally_of(ending.stdout)
    print(f"{name}: {everywhere} pixels differ, {off_edges} off edges; rays {told} and {rays}",
          flush=True)
    allowed = 2 * samples
    checks.expect(off_edges == 0, f"{name}: {off_edges} pixels differ off edges")
    checks.expect(everywhere <= allowed, f"{name}: {everywhere} pixels differ")
    if samples == 1:
        apart = max(abs(a - b) for a, b in zip(told, rays))
        checks.expect(apart <= 2, f"{name}: rays by verdict {told}, not {rays}")
    checks.equal(page.console, [], f"{name}: the console")


def test(given, folder, driven, checks):
    for case in ALL if given.all else QUICK:
        compare(given, folder, driven, checks, *case)


if __name__ == "__main__":
    pages.main(test, **{"--all": {"action": "store_true"}})

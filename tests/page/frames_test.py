#!/usr/bin/env python3
"""Frames of pages against `isomotion render`: the same verdicts, the same colours.

    frames_test.py PROGRAM [--all]

Pictures are of 128 x 128, and with --all of 256 x 256. Pixels may differ at silhouettes: one there, two here.
"""
import os

import pages
import png

# Scenes of the gallery with the frame looked at, what is changed in them, what sliders hold, and how
# few evaluations of a draw make the page draw the picture again in passes.
CAMERA = "camera={position=[6, 4, 3], target=[0, 0, 0], fov=36}"
QUICK = [
    ("blobby75_chrome", 40, []),
    ("blobby75", 20, [CAMERA], {"s": 1.45, "R": 0.3}),
    ("many.toml", 2, []),
    ("lists.toml", 2, []),
    ("blobby75", 30, [], {}, 5),
    ("several.toml", 2, []),
    ("glass.toml", 2, []),
]
ALL = QUICK + [
    ("blobby75", 40, []),
    ("over.toml", 2, []),
    ("blur.toml", 2, []),
    ("twisting_superquadric", 16, []),
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
    ("many.toml", 3, [CAMERA]),
    ("capsules.toml", 2, []),
    ("lists.toml", 2, [CAMERA, "surface.bounds={box = [[-1, -1, -1], [1.2, 1, 1]]}"], {"c": 0.3}),
    ("blur.toml", 2, [], {"c": 0.4}),
    ("cut.toml", 3, []),
    ("cut.toml", 3, [CAMERA]),
    ("sliced_gyroid", 20, []),
    ("soft.toml", 1, []),
    ("wide.toml", 1, []),
    ("over.toml", 3, [CAMERA], {"balls/c": 0.4, "ring/a": 0.2}),
    ("over.toml", 2, [], {}, 5),
    ("several.toml", 3, [CAMERA]),
    ("passing_through", 40, []),
    ("passing_through", 110, [CAMERA]),
    ("glass.toml", 3, [CAMERA]),
    ("glass_within.toml", 1, []),
    ("glass_drops", 30, []),
    ("far.toml", 3, []),
    ("far.toml", 2, [], {"px": 499990}),
]
# Pictures whose mean a frame is.
SAMPLES = {"lens.toml": 4, "look.toml": 4, "blur.toml": 4, "soft.toml": 16, "several.toml": 4}
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
    # Elements by the thousand, found by place.
    "many.toml": """[time]
frames = 4
[surface]
formula = "sum(b, exp(-900*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5 - p"
bounds = { sphere = 2 }
[parameters]
p = 0.1
[arrays.b]
count = 5000
a = "2*pi*random(i, 1) + 0.2*t"
h = "2*random(i, 2) - 1"
r = "1.2*random(i, 3)^0.4"
cx = "r*sqrt(1 - h^2)*cos(a)"
cy = "r*sqrt(1 - h^2)*sin(a)"
cz = "r*h"
""",
    # The least of many capsules, which are no balls; with shadows, and coloured by the nearest.
    "capsules.toml": """[time]
frames = 3
[surface]
formula = "least(b, sqrt((x-cx)^2 + (y-cy)^2 + max(abs(z-cz) - l, 0)^2) - 0.05)"
bounds = { sphere = 2 }
[arrays.b]
count = 1500
l = "0.1*random(i, 4)"
cx = "2.4*random(i, 1) - 1.2"
cy = "2.4*random(i, 2) - 1.2"
cz = "2*random(i, 3) - 1 + 0.1*t"
[[lights]]
direction = [1, 2, 2]
shadow = true
""",
    # As many elements as beams have lists for, of two texels, cut open and painted; more of them
    # matter in some beams than rays' lists have places for.
    "lists.toml": """[time]
frames = 4
fps = 4
[surface]
formula = "(2 + x)*sum(b, w*exp(-k*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.8 - 0.1*c"
bounds = { sphere = 1.6 }
[parameters]
c = "0.2*t"
[arrays.b]
count = 384
cx = "1.3*sin(i + c)"
cy = "1.3*sin(2*i + t)"
cz = "1.3*sin(3*i)"
k = "20 + 20*random(i, 1)"
w = "0.2 + 0.1*random(i, 2)"
[[sections]]
normal = [1, 0, 0]
offset = 0.4
[material.colormap]
value = "mean_curvature"
range = [-6, 6]
""",
    # Elements of so many fields that their lists would fit into no texture.
    "wide.toml": """[surface]
formula = "sum(b, exp(-30*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))*%s) - 0.5"
bounds = { sphere = 2 }
[arrays.b]
count = 300
cx = "1.3*sin(i)"
cy = "1.3*sin(2*i)"
cz = "1.3*sin(3*i)"
%s
""" % ("*".join(f"f{k}" for k in range(40)),
       "\n".join(f'f{k} = "1 + 0.01*random(i, {k})"' for k in range(40))),
    # Motion blur, of elements found by place as well, and of the camera.
    "blur.toml": """[time]
frames = 4
fps = 4
[surface]
formula = "sum(b, exp(-30*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5 - 0.1*c"
bounds = { sphere = 2 }
[parameters]
c = "0.2*t"
[arrays.b]
count = 200
cx = "1.3*sin(i + t)"
cy = "1.3*sin(2*i + c)"
cz = "1.3*sin(3*i)"
[camera]
azimuth = "30 + 20*t"
shutter = 0.5
[output]
samples = 4
""",
    # Sections with caps of a colour of their own, and contours.
    "cut.toml": """[time]
frames = 4
[surface]
formula = "x^4 + y^4 + z^4 - x^2 - y^2 - z^2 + 0.3*x*y*z + 0.2"
bounds = { sphere = 2 }
[[sections]]
normal = [1, -0.6, 0.4]
offset = "0.2 + 0.1*t"
[[sections]]
centre = [-0.3, 0.6, 0.7]
sphere = 0.5
[material]
cap_color = [0.8, 0.3, 0.1]
[material.contours]
value = "z + 0.2*x"
every = 0.2
[[lights]]
direction = [1, -1, 2]
shadow = true
""",
    # A look as the gallery's animations have it: soft shadows, light from everywhere, 16 pictures.
    "soft.toml": """look = "clay"
[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1"
bounds = { sphere = 1.5 }
[ambient]
top = [0.3, 0.3, 0.35]
bottom = [0.1, 0.1, 0.08]
[[lights]]
direction = [1, 1, 2]
shadow = true
radius = 10
""",
    # Plain surfaces that meet, by three methods, one of many elements, one turned and scaled.
    "over.toml": """[time]
frames = 4
[[surfaces]]
name = "balls"
formula = "sum(b, exp(-9*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - 0.5 - 0.1*c"
bounds = { sphere = 2 }
parameters = { c = "0.2*t" }
[surfaces.arrays.b]
count = 40
cx = "1.2*sin(i + c)"
cy = "1.2*sin(2*i + t)"
cz = "1.2*sin(3*i)"
[surfaces.material]
color = [0.8, 0.3, 0.1]
[[surfaces]]
name = "ring"
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - a^2"
parameters = { a = 0.3 }
bounds = { box = [[-1.3, -1.3, -0.3], [1.3, 1.3, 0.3]] }
transform = { rotate = [20, "40*t", 60], scale = 1.4, translate = [0.2, 0.1, "0.3*t"] }
[[surfaces]]
name = "cube"
formula = "max(abs(x), abs(y), abs(z)) - 0.8"
bounds = { sphere = 1.5 }
transform = { rotate = [10, 20, 30] }
isolation = { method = "interval" }
material = { color = [0.1, 0.3, 0.8] }
""",
    # Surfaces that mirror, shadow and darken each other over ground, in a map; with a light that has
    # a size, a section and the mean of pictures.
    "several.toml": """[time]
frames = 4
[[surfaces]]
name = "mirror"
formula = "x^2 + y^2 + z^2 - 1"
bounds = { sphere = 1.2 }
transform = { translate = ["-0.9 + 0.2*t", 0, 0.2], scale = 0.8 }
[surfaces.material]
model = "ggx"
metallic = 0.8
roughness = 0.2
reflection = "self"
[[surfaces]]
name = "ring"
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - 0.1"
bounds = { box = [[-1.4, -1.4, -0.4], [1.4, 1.4, 0.4]] }
transform = { rotate = [80, "30*t", 0], translate = [0.6, 0, 0] }
material = { model = "blinn-phong", color = [0.8, 0.3, 0.1] }
[[sections]]
normal = [0.2, 1, 0.3]
offset = 0.5
[[lights]]
direction = [1, -0.5, 1.2]
shadow = true
radius = 8
[[lights]]
position = [-3, -2, 4]
falloff = 5
shadow = true
[ground]
height = -1.2
[occlusion]
[environment]
map = "studio.exr"
[output]
samples = 4
""",
    # Glass with a highlight, cut open, over ground that shadows fall on.
    "glass.toml": """[time]
frames = 4
[surface]
formula = "(sqrt(x^2 + y^2) - 1)^2 + z^2 - a"
bounds = { sphere = 1.6 }
transform = { rotate = [70, "40*t", 0] }
[parameters]
a = "0.15 + 0.02*t"
[material]
transmission = 0.9
ior = 1.4
absorption = [0.6, 0.1, 0.3]
model = "ggx"
roughness = 0.2
[[sections]]
normal = [1, 0.3, 0.2]
offset = 0.9
[ground]
height = -1.6
[[lights]]
direction = [1, -1, 2]
shadow = true
[environment]
map = "studio.exr"
""",
    # From within glass, and before a plain background.
    "glass_within.toml": """[surface]
formula = "x^2 + y^2 + z^2 - 1 + 0.2*sin(5*x)*sin(5*y)"
bounds = { sphere = 1.4 }
[material]
transmission = 1
depth = 3
[camera]
position = [0.2, -0.3, 0.1]
target = [1, 0.4, 0.2]
fov = 90
""",
    # Coordinates, elements and a parameter far from the origin.
    "far.toml": """[time]
frames = 4
[surface]
formula = "min(sum(b, exp(-((x - cx)^2 + (y - cy)^2 + (z - 120)^2)/50)) - 0.5, (x - px)^2 + (y - 4649776)^2 + (z - 130)^2 - 64)"
bounds = { sphere = 60, centre = ["500000 + t", 4649776, 120] }
[parameters]
px = "500000 + 10*t"
[arrays.b]
count = 12
cx = "500000 + 20*sin(i) + t"
cy = "4649776 + 20*cos(i)"
[material]
color = ["0.5 + (x - 500000)/80", 0.4, 0.3]
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


def key_of(name):
    """The key of a parameter of the only surface, or (SURFACE/NAME) of one of several."""
    surface, _, own = name.rpartition("/")
    return f"surfaces.{surface}.parameters.{own}" if surface else name


def compare(given, folder, driven, checks, side, name, frame, changes, held={}, evaluations=None):
    # One picture a frame shows where a pixel differs.
    if not name.endswith(".toml"):
        changes = ["look=none", "output.samples=1", *changes]
    settings = [word for change in changes for word in ("--set", change)]
    scene = scene_file(name, folder)
    file = pages.made(given.program, scene, os.path.join(folder, "page.html"), *settings)
    ending = pages.run(given.program, "render", scene, "--frames", str(frame), "--size",
                       f"{side}x{side}", "--audit", "off", "-o", os.path.join(folder, "r.####.png"),
                       *settings, *[word for name, value in held.items()
                                    for word in ("--set", f"{key_of(name)}={value}")])
    checks.equal(ending.returncode, 0, f"render {name}: {ending.stderr}")
    with open(os.path.join(folder, f"r.{frame:04}.png"), "rb") as rendered:
        wanted = png.read(rendered.read())
    page = driven.page(side, side)
    samples = SAMPLES.get(name, 1)
    page.open(file, f"?ui=0&tally&samples={samples}",
              f"#f={frame}" + "".join(f"&{name}={value}" for name, value in held.items()))
    page.until_at_rest()
    if evaluations:
        checks.expect(page.evaluate("isomotion.painter.tile.isFused"), f"{name}: one draw is enough")
        page.evaluate(f"isomotion.painter.data.about.surfaces.forEach((one) => one.evaluations = {evaluations});"
                      "isomotion.painter.change(false)")
        page.until_at_rest()
        checks.expect(not page.evaluate("isomotion.painter.tile.isFused"), f"{name}: falls back")
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
    allowed = side // 128 * samples
    checks.expect(off_edges == 0, f"{name}: {off_edges} pixels differ off edges")
    checks.expect(everywhere <= allowed, f"{name}: {everywhere} pixels differ")
    if samples == 1:
        apart = max(abs(a - b) for a, b in zip(told, rays))
        checks.expect(apart <= 2, f"{name}: rays by verdict {told}, not {rays}")
    checks.equal(page.console, [], f"{name}: the console")


def test(given, folder, driven, checks):
    for case in ALL if given.all else QUICK:
        compare(given, folder, driven, checks, 256 if given.all else 128, *case)


if __name__ == "__main__":
    pages.main(test, **{"--all": {"action": "store_true"}})

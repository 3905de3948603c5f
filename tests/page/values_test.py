#!/usr/bin/env python3
"""What a page works out by expressions against what it holds as values: the same bits in all frames.

    values_test.py PROGRAM
"""
import os

import pages

# Expressions of every function, numbers, lists, siblings that the formula reads or does not, other
# parameters; some values are at or near 0, where functions of browsers differ by more than a float.
SCENE = """[time]
fps = 8
frames = 33
[surface]
formula = "sum(b, w*exp(-8*((x-cx)^2 + (y-cy)^2 + (z-cz)^2))) - q"
bounds = {{ sphere = 4 }}
[camera]
shutter = 0.5
[output]
samples = 4
[parameters]
q = 0.3
p = 3.2
c = "0.2 + 0.1*t*p"
{held}
[arrays.b]
count = 40
w = "0.5 + 0.1*abs(v)*floor(2*random(i, 3)){and_held}"
u = "random(i, 1) - 0.5"
v = {list}
cx = "sin(2*pi*t)*u + cos(i)*sign(t - 2){and_held}"
cy = "v*c + 0.1*sinh(t)*cosh(u)/p - 0.1*asin(c/4)*acos(c/4) + sqrt(t)*atan(t*u){and_held}"
cz = "min(sin(i*c + t), max(exp(-t), log(1 + t)))*i/n + tan(u)*tanh(t){and_held}"
"""
# A track of keys, which a page does not work out; it adds 0.
HELD = {"held": "k = { keys = [[0, 0], [4, 0]] }", "and_held": " + k"}
BITS = """(() => {
    const [values] = isomotion.painter.data.surfaces, { frames, moments } = isomotion.about;
    const all = [];
    for (let frame = 1; frame <= frames; ++frame)
        for (let m = 0; m < moments.length; ++m)
            all.push([...new Uint32Array(values.elements(0, frame, m).buffer)]);
    return { all, computed: values.about.arrays[0].computed,
        exceptions: [...values.exceptions[0] ?? []].reduce((n, [, its]) => n + its.length, 0) };
})()"""


def bits_of(given, folder, driven, name, parts):
    scene = os.path.join(folder, name + ".toml")
    with open(scene, "w") as text:
        text.write(SCENE.format(list=[round(0.1 * (k % 7) - 0.3, 2) for k in range(40)], **parts))
    page = driven.page(64, 64)
    page.open(pages.made(given.program, scene, os.path.join(folder, name + ".html")),
              "?ui=0&play=0&samples=1")
    found = page.evaluate(BITS)
    page.close()
    return found


def test(given, folder, driven, checks):
    by_expressions = bits_of(given, folder, driven, "by", {"held": "", "and_held": ""})
    as_values = bits_of(given, folder, driven, "as", HELD)
    checks.equal(as_values["computed"], None, "what is worked out where a track has keys")
    checks.expect(by_expressions["computed"] and len(by_expressions["computed"]["fields"]) == 3,
                  f"fields worked out: {by_expressions['computed']}")
    checks.expect(by_expressions["exceptions"] > 0, "values near 0 are kept")
    rows = list(zip(by_expressions["all"], as_values["all"]))
    checks.equal(len(rows), 33 * 4, "moments")
    apart = sum(a != b for one, other in rows for a, b in zip(one, other))
    print(f"{apart} of {sum(len(one) for one, _ in rows)} words differ; "
          f"{by_expressions['exceptions']} are kept")
    checks.equal(apart, 0, "words that differ")


if __name__ == "__main__":
    pages.main(test)

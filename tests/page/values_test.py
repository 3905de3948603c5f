#!/usr/bin/env python3
"""What a page works out by expressions against what it holds as values: the same bits in all frames,
also where the browser's functions have other last bits.

    values_test.py PROGRAM
"""
import os

import pages

# Expressions of every function, numbers, lists, siblings that the formula reads or does not, other
# parameters; some values are at or near 0, where functions of browsers differ by more than a float. The
# first element's cz tells the last bits of exp.
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
cz = "min(sin(i*c + t), max(exp(-t), log(1 + t)))*i/n + tan(u)*tanh(t) + 0.1*asinh(v)*acosh(1 + t) + 0.1*erf(u*t)*cbrt(v) + noise(1.3*t, i - 2.5, v) + 1e10*max(1 - i, 0)*(exp(t)*exp(-t) - 1){and_held}"
"""
# A track of keys, which a page does not work out; it adds 0.
HELD = {"held": "k = { keys = [[0, 0], [4, 0]] }", "and_held": " + k"}
# Functions of a browser may give other last bits. These do, up or down.
OTHER_MATH = """for (const name of ["sin", "cos", "tan", "exp", "log", "sinh", "cosh", "tanh", "asin",
    "acos", "atan", "asinh", "acosh", "cbrt"]) {
    const own = Math[name], words = new BigInt64Array(1), doubles = new Float64Array(words.buffer);
    const most = { sin: 1, cos: 1, tanh: 1 }[name] ?? Infinity;
    Math[name] = (x) => {
        doubles[0] = own(x);
        if (doubles[0] === 0 || Math.abs(doubles[0]) === most) return doubles[0];
        words[0] += doubles[0] > 0 ? %sn : -%sn;
        return doubles[0];
    };
}"""
WITHOUT_EXCEPTIONS = "isomotion.painter.data.surfaces[0].exceptions.forEach((rows) => rows?.clear())"
BITS = """(() => {
    const [values] = isomotion.painter.data.surfaces, { frames, moments } = isomotion.about;
    const all = [];
    for (let frame = 1; frame <= frames; ++frame)
        for (let m = 0; m < moments.length; ++m)
            all.push([...new Uint32Array(values.elements(0, frame, m).buffer)]);
    return { all, computed: values.about.arrays[0].computed,
        exceptions: [...values.exceptions[0] ?? []].reduce((n, [, its]) => n + its.length, 0) };
})()"""


def bits_of(given, folder, driven, name, parts, script="", change=None):
    scene = os.path.join(folder, name + ".toml")
    with open(scene, "w") as text:
        text.write(SCENE.format(list=[round(0.1 * (k % 7) - 0.3, 2) for k in range(40)], **parts))
    page = driven.page(64, 64)
    page.call("Page.addScriptToEvaluateOnNewDocument", source=script)
    page.open(pages.made(given.program, scene, os.path.join(folder, name + ".html")),
              "?ui=0&play=0&samples=1")
    found = page.evaluate(BITS)
    if change:
        page.evaluate(change)
        found["changed"] = page.evaluate(BITS)["all"]
    page.close()
    return found


def apart(some, others):
    """How many words differ."""
    return sum(a != b for one, other in zip(some, others) for a, b in zip(one, other))


def test(given, folder, driven, checks):
    by_expressions = bits_of(given, folder, driven, "by", {"held": "", "and_held": ""})
    as_values = bits_of(given, folder, driven, "as", HELD)
    checks.equal(as_values["computed"], None, "what is worked out where a track has keys")
    checks.expect(by_expressions["computed"] and len(by_expressions["computed"]["fields"]) == 3,
                  f"fields worked out: {by_expressions['computed']}")
    checks.expect(by_expressions["exceptions"] > 0, "values near 0 are kept")
    wanted = as_values["all"]
    checks.equal((len(wanted), len(by_expressions["all"])), (33 * 4, 33 * 4), "moments")
    differing = apart(by_expressions["all"], wanted)
    print(f"{differing} of {sum(map(len, wanted))} words differ; "
          f"{by_expressions['exceptions']} are kept")
    checks.equal(differing, 0, "words that differ")
    for step in (1, -1):
        other = bits_of(given, folder, driven, "by", {"held": "", "and_held": ""},
                        OTHER_MATH % (step, step), WITHOUT_EXCEPTIONS)
        without = apart(other["changed"], wanted)
        print(f"with functions whose last bits differ by {step}: "
              f"{apart(other['all'], wanted)} words differ, {without} where none is kept")
        checks.equal(apart(other["all"], wanted), 0, f"words that differ with last bits {step}")
        checks.expect(without > 0, f"values that are kept matter with last bits {step}")


if __name__ == "__main__":
    pages.main(test)

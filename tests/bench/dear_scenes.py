#!/usr/bin/env python3
"""What scenes that are as dear as the limits allow (docs/security.md) cost to read and to sample.

    tests/bench/dear_scenes.py [ISOMOTION]

Writes scenes into a temporary folder and runs `show` and `topology --certify off` on each: processor
time, memory, exit code. Ends with 1 where one takes over 10 s or 1 GB, is not shown, or where topology
ends with anything but a timeline or an error in what was asked for.
"""

import os
import pathlib
import subprocess
import sys
import tempfile

SURFACE = "[surface]\nbounds = {{ sphere = 2 }}\nformula = '''{}'''\n"
REST = "[output]\nsize = [64, 64]\n[time]\nframes = 100\n"


def scene(formula, arrays=""):
    return SURFACE.format(formula) + REST + arrays


def array(name, count, fields):
    lines = "".join(f'{field} = "{value}"\n' for field, value in fields.items())
    return f"[arrays.{name}]\ncount = {count}\n{lines}"


def sums(terms, count):
    body = "+".join(f"exp(-((x-c*{k})^2+(y-c)^2+z^2))" for k in range(1, terms + 1))
    return scene(f"sum(a, {body}) - 0.5", array("a", count, {"c": "sin(i)"}))


def chain(levels, step, last):
    parts = "".join(f"u{k + 1} = {step.format(k)};" for k in range(levels))
    return f"u0 = x; {parts} {last.format(levels)}"


def scenes():
    many = {f"f{k}": f"sin(i*{k}+t)" for k in range(9)}
    yield "values", scene(f"x + sum(a, {'+'.join(many)})*1e-9", array("a", 10**6, many))
    sines = "+".join(f"sin(t*{k}+i)" for k in range(30))
    yield "work of a frame", scene("x + sum(a, f)*1e-9", array("a", 10**6, {"f": sines}))
    unread = "".join(
        array(f"a{k}", 10**6, {f"f{m}": f"i*{m}" for m in range(300)}) for k in range(32)
    )
    yield "unread fields", scene("x", unread)
    yield "work at a point", sums(3, 10**6)
    yield "more of it", sums(8, 6 * 10**5)
    yield "terms of a shader", sums(3, 55000)
    waves = "+".join(f"sin({k}*x+{k % 7}*y)*cos({k % 13}*z)" for k in range(1, 9000))
    yield "waves", scene(waves)
    yield "a chain of sines", scene(chain(9000, "sin(u{0}*y+z)*u{0}", "u{}-y"))
    yield "a chain of min and max", scene(chain(5000, "min(u{0},x-{0}*y)+max(u{0},z)", "u{}-y"))
    elements = array("b", 2, {"c": "i"})
    yield "a chain of sums", scene(chain(16000, "sum(b,u{0}*c/9)", "u{}-y"), elements)
    yield "another", scene(chain(9000, "sum(b,sin(u{0}+c))", "u{}-y"), elements)
    yield "degree 1000", scene("chebyshev(1000,x)+chebyshev(999,y)+chebyshev(998,z)")
    rough = "+".join(f"abs(x-{k}/300)^0.3*sign(y-{k}/200)" for k in range(1500))
    yield "kinks and jumps", scene(rough)
    yield "surface everywhere", scene("+".join(f"sin({90+k}*x)*cos({k}*y-z)" for k in range(900)))
    yield "a million frames", scene("x-c*1e-6").replace("frames = 100", "frames = 1000000") + "[parameters]\nc = 't'\n"
    turning = "+".join(f"acos(sin({k}*x+y*{k + 1}+p))^(p+1.5)" for k in range(9000))
    yield "kinks that may be", scene(turning, "[parameters]\np = 't'\n")
    steps = "+".join(f"floor({k % 7 + 1}*x+y/{k + 1})" for k in range(10000))
    yield "steps", scene(steps)
    moving = {"cx": "sin(i*t+i)", "cy": "cos(i*t+2*i)", "cz": "sin(3*i+t)", "r": "1+random(i,0)"}
    power = "sum(a, 1/(exp(x-cx)+sin(y-cy)^1.3+(z-cz)^r+0.01)) - 5"
    yield "functions of elements", scene(power, array("a", 10**6, moving))
    long = "+".join(f"sin({k}*t)" for k in range(20000))
    often = scene("x-p", f"[parameters]\np = '{long}'\n")
    yield "a long expression of time", often.replace("frames = 100", "frames = 100000")
    # Texts that say many names, of fields with many siblings.
    names = {f"g{k}": f"i*{k}" for k in range(900)}
    said = "+".join(f"g{k % 900}" for k in range(80000))
    yield "many names", scene("x-sum(a, f0)*1e-9", array("a", 2, names | {"f0": said}))
    yield "many names of a sum", scene(f"x-sum(a, {said})*1e-9", array("a", 2, names))
    tables = "".join(f'[arrays.a{k}]\nfile = "table.csv"\n' for k in range(32))
    yield "a table named often", scene("x+" + "+".join(f"sum(a{k}, c1)" for k in range(32)), tables)
    # One column and the time each.
    ways = "".join(
        f'[arrays.a{k}]\nfile = "unspoken.csv"\ncolumns = {{ c = "c.{k}" }}\n' for k in range(16)
    )
    yield "a table read in many ways", scene("x+" + "+".join(f"sum(a{k}, c)" for k in range(16)), ways)
    for kind in ["times", "ids"]:
        table = f'[arrays.a]\nfile = "{kind}.csv"\nextrapolate = "hold"\n'
        yield f"a table of {kind}", scene("x+sum(a, c)*1e-9", table)


def write_tables(folder):
    # No more than a row in memory: what a program takes counts from what this one takes.
    for name, column in [("table.csv", "c"), ("unspoken.csv", "c.")]:
        with open(folder / name, "w") as table:
            table.write("frame," + ",".join(f"{column}{k}" for k in range(30)) + "\n")
            for row in range(900_000):
                table.write(f"{1 + row // 9000}," + ",".join([f"{row % 97 * 0.01:.3f}"] * 30) + "\n")
    # As many numbers as may be kept.
    with open(folder / "times.csv", "w") as table:
        table.write("t,c\n")
        table.writelines(f"{row},1\n" for row in range(14_999_999))
    with open(folder / "ids.csv", "w") as table:
        table.write("frame,id,c\n")
        table.writelines(f"{1 + row // 999_999},{row * 7919 % 10_000_019},1\n" for row in range(9_999_990))


# The commands, with the exit codes that are right.
COMMANDS = [(["show"], [0]), (["topology", "--certify", "off"], [0, 2])]


def cost(words):
    """What a command costs with all its threads, in seconds and megabytes, and its exit code."""
    run = subprocess.Popen(words, stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL)
    _, status, used = os.wait4(run.pid, 0)
    seconds = used.ru_utime + used.ru_stime
    return seconds, used.ru_maxrss / 1024, os.waitstatus_to_exitcode(status)


def main():
    program = sys.argv[1] if len(sys.argv) > 1 else "build/release/isomotion"
    with tempfile.TemporaryDirectory() as folder:
        write_tables(pathlib.Path(folder))
        dear = []
        print("| scene | command | seconds | MB | exit code |\n|---|---|--:|--:|--:|")
        for name, text in scenes():
            file = pathlib.Path(folder) / "scene.toml"
            file.write_text(text)
            for command, codes in COMMANDS:
                seconds, megabytes, code = cost([program, *command, str(file)])
                print(
                    f"| {name} | {command[0]} | {seconds:.1f} | {megabytes:.0f} | {code} |", flush=True
                )
                if seconds > 10 or megabytes > 1024 or code not in codes:
                    dear.append(f"{command[0]} of {name}")
    if dear:
        sys.exit("too dear, or not done: " + ", ".join(dear))


if __name__ == "__main__":
    main()

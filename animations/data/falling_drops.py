#!/usr/bin/env python3
"""Makes falling_drops.csv: 300 drops rain into a round bowl, bounce, and gather in a pool.

Positions of drops every fourth frame of 30 a second. Only + - * / and sqrt are used, which IEEE 754
rounds the same everywhere, and random numbers from integers: the file is the same on any machine.
"""
import math
import sys

DROPS = 300
LAST_FRAME = 121  # one beyond the animation's 120, so that all of them lie between samples
STRIDE = 4
SUBSTEPS = 6
DT = 1.0 / (30 * SUBSTEPS)

GRAVITY = 3.0
SPACING = 0.125   # drops closer than this push each other off,
REACH = 0.19      # and closer than this hold together
PUSH = 900.0
PULL = 10.0
FRICTION = 2.2    # between neighbours: what makes the pool come to rest
DRAG = 0.25
BOWL = 0.32       # its floor is z = BOWL * (x^2 + y^2)
BOUNCE = 0.35


def random_numbers(seed):
    """Uniform in [0, 1), from a 64-bit linear congruential generator (Knuth's MMIX)."""
    state = seed
    while True:
        state = (state * 6364136223846793005 + 1442695040888963407) % 2**64
        yield (state >> 11) / 2**53


def new_drop(number, random):
    """Over a disc of radius 0.85; the first ones are on their way when the animation begins."""
    while True:
        x, y = 2 * next(random) - 1, 2 * next(random) - 1
        if x * x + y * y < 1:
            break
    height = 0.75 + 1.45 * number / 60 if number < 60 else 2.2
    return [0.85 * x, 0.85 * y, height, 0.0, 0.0, -0.6]


def neighbours(drops):
    """Pairs closer than REACH, in an order that does not depend on the machine."""
    cells = {}
    for k, drop in enumerate(drops):
        cell = tuple(math.floor(c / REACH) for c in drop[:3])
        cells.setdefault(cell, []).append(k)
    for a, drop in enumerate(drops):
        cx, cy, cz = (math.floor(c / REACH) for c in drop[:3])
        for ix in (cx - 1, cx, cx + 1):
            for iy in (cy - 1, cy, cy + 1):
                for iz in (cz - 1, cz, cz + 1):
                    for b in cells.get((ix, iy, iz), ()):
                        if b > a:
                            yield a, b


def step(drops):
    forces = [[0.0, 0.0, -GRAVITY] for _ in drops]
    for a, b in neighbours(drops):
        p, q = drops[a], drops[b]
        d = [q[k] - p[k] for k in range(3)]
        square = d[0] * d[0] + d[1] * d[1] + d[2] * d[2]
        if square >= REACH * REACH or square == 0:
            continue
        distance = math.sqrt(square)
        if distance < SPACING:
            force = -PUSH * (SPACING - distance)
        else:
            force = PULL * (REACH - distance)
        for k in range(3):
            f = force * d[k] / distance + FRICTION * (q[3 + k] - p[3 + k])
            forces[a][k] += f
            forces[b][k] -= f
    for drop, force in zip(drops, forces):
        for k in range(3):
            drop[3 + k] += DT * (force[k] - DRAG * drop[3 + k])
            drop[k] += DT * drop[3 + k]
        land(drop)


def land(drop):
    """Keeps a drop above the bowl's floor; what it moved into the floor bounces back, weaker."""
    x, y = drop[0], drop[1]
    depth = BOWL * (x * x + y * y) - drop[2]
    if depth <= 0:
        return
    normal = [-2 * BOWL * x, -2 * BOWL * y, 1.0]
    length = math.sqrt(normal[0] * normal[0] + normal[1] * normal[1] + 1)
    normal = [n / length for n in normal]
    into = sum(drop[3 + k] * normal[k] for k in range(3))
    for k in range(3):
        drop[k] += depth / length * normal[k]
        if into < 0:
            drop[3 + k] -= (1 + BOUNCE) * into * normal[k]
        drop[3 + k] *= 1 - 1.5 * DT


def main():
    out = open(sys.argv[1], "w", newline="\n") if len(sys.argv) > 1 else sys.stdout
    random = random_numbers(20100401)
    drops = [new_drop(k, random) for k in range(60)]
    out.write("# Made by falling_drops.py.\nframe,id,x,y,z\n")
    for frame in range(1, LAST_FRAME + 1):
        if frame % STRIDE == 1:
            for number, drop in enumerate(drops):
                x, y, z = (round(c, 3) + 0.0 for c in drop[:3])
                out.write(f"{frame},{number},{x:g},{y:g},{z:g}\n")
        wanted = min(DROPS, 60 + 4 * frame)
        while len(drops) < wanted:
            drops.append(new_drop(len(drops), random))
        for _ in range(SUBSTEPS):
            step(drops)


if __name__ == "__main__":
    main()

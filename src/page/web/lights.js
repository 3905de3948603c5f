// Lights of the block Shading that depend on who looks or on the picture of a frame: those that go with
// the camera, and those that have a size (src/scene/light_points.cpp in the same arithmetic).

const isSameCamera = (a, b) => ["position", "target", "up"].every((part) =>
    a[part].every((x, k) => x === b[part][k]));

// Takes a direction from the viewer's right, up and back in one view to those in another.
function goneAlong(direction, from, to) {
    const [before, after] = [pictureAxes(from), pictureAxes(to)];
    const world = turned(from.rotate, direction);
    const moved = add(add(times(dot(before.right, world), after.right),
        times(dot(before.up, world), after.up)),
    times(dot(before.forward, world), after.forward));
    return turnedBack(to.rotate, moved);
}

// A direction to a light far away, or (`isNear`) the place of one, as the disc's point [x, y] has it.
// The disc faces `middle`, of the bounds in the world.
function onDisc(light, isNear, radius, view, middle, [x, y]) {
    const toWorld = (v) => turned(view.rotate, v);
    const from = isNear ? add(view.translate, times(view.scale, toWorld(light))) : toWorld(light);
    const way = isNear ? sub(from, middle) : from;
    if (length(way) === 0) return light;
    const ahead = normalized(way);
    const a = normalized(cross(Math.abs(ahead[2]) < 0.9 ? [0, 0, 1] : [1, 0, 0], ahead));
    const b = cross(ahead, a);
    const moved = add(from, times(radius, add(times(x, a), times(y, b))));
    return isNear
        ? times(1 / view.scale, turnedBack(view.rotate, sub(moved, view.translate)))
        : turnedBack(view.rotate, normalized(moved));
}

// Changes `shading`, which has lights as they are at `own`, the scene's view of the frame.
function moveLights(shading, about, own, view, middle, [, , x, y]) {
    const place = (k) => 4 * (2 + k);
    const lightAt = (k) => Array.from(shading.subarray(place(k), place(k) + 3));
    if (!isSameCamera(own, view)) {
        for (const k of about.viewersLights)
            shading.set(goneAlong(lightAt(k), own, view), place(k));
    }
    if (x === 0 && y === 0) return;
    [view.lightRadius].flat().forEach((radius, k) => {
        if (radius === 0) return;
        const isNear = shading[place(k) + 3] !== 0;
        shading.set(onDisc(lightAt(k), isNear, radius, view, middle, [x, y]), place(k));
    });
}

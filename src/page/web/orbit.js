// Moves cameras by hand, as src/player/model/orbit.cpp does: from a view and a drag to a camera, the
// part of a view that people change. Drags and places are in heights of the picture, to the right and
// up; places count from its middle.

const degreesPerHeight = 180;
const poleDistance = 0.1; // degrees

const cameraOf = ({ position, target, height }) => ({ position, target, height });

function pictureAxes(view) {
    const forward = normalized(sub(view.target, view.position));
    let up = view.up;
    if (length(cross(forward, up)) < 1e-9 * length(up))
        up = Math.abs(forward[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    const right = normalized(cross(forward, up));
    return { right, up: cross(right, forward), forward };
}

const slopeOf = (view) => (Math.tan(radians(view.fov) / 2) / view.zoom) * (view.fit ?? 1);
const distanceOf = (view) => length(sub(view.target, view.position));
const shownHeight = (view) => view.parallel
    ? (view.height / view.zoom) * (view.fit ?? 1)
    : 2 * distanceOf(view) * slopeOf(view);

// The point of the plane through the target that is seen there.
function pointAt(view, [x, y]) {
    const { right, up } = pictureAxes(view);
    return add(view.target, times(shownHeight(view), add(times(x, right), times(y, up))));
}

// A camera that numbers can hold, or the one before.
function usable(moved, view) {
    const away = distanceOf(moved);
    const coarse = Math.max(length(moved.position), length(moved.target));
    const fits = Number.isFinite(coarse) && coarse < 1e30 && away > 1e-9 * coarse && away > 1e-30 &&
        moved.height > 1e-30 && moved.height < 1e30;
    return fits ? moved : cameraOf(view);
}

function directionOf(view) {
    const pole = normalized(view.up);
    const back = normalized(sub(view.position, view.target));
    const height = dot(back, pole);
    const across = sub(back, times(height, pole));
    const elevation = Math.atan2(height, length(across));
    let level = across;
    if (length(across) < 1e-9) {
        const upright = pictureAxes(view).up;
        level = height > 0 ? times(-1, upright) : upright;
    }
    return { pole, level: normalized(sub(level, times(dot(level, pole), pole))), elevation };
}

// Turns about the target as if the drag turned the surface.
function orbited(view, [x, y]) {
    const turn = radians(degreesPerHeight), highest = radians(90 - poleDistance);
    const from = directionOf(view);
    const azimuth = -turn * x;
    const elevation = clamp(from.elevation - turn * y, -highest, highest);
    const level = add(times(Math.cos(azimuth), from.level),
        times(Math.sin(azimuth), cross(from.pole, from.level)));
    const direction = add(times(Math.cos(elevation), level),
        times(Math.sin(elevation), from.pole));
    const position = add(view.target, times(distanceOf(view), direction));
    return usable({ ...cameraOf(view), position }, view);
}

// What is as far away as the target stays under the hand.
function panned(view, drag) {
    const shift = sub(view.target, pointAt(view, drag));
    return usable({ position: add(view.position, shift), target: add(view.target, shift),
        height: view.height }, view);
}

// Nearer by the factor exp(-amount); what is at that place stays there.
function dollied(view, amount, at = [0, 0]) {
    const factor = Math.exp(-amount);
    const fixed = pointAt(view, at);
    const near = (point) => add(fixed, times(factor, sub(point, fixed)));
    const target = near(view.target);
    if (!view.parallel)
        return usable({ position: near(view.position), target, height: view.height }, view);
    return usable({ position: add(view.position, sub(target, view.target)), target,
        height: view.height * factor }, view);
}

// A ball about the bounds of a surface, in the world.
const ballAbout = (view) => ({
    centre: add(view.translate, times(view.scale, turned(view.rotate, view.centre))),
    radius: view.radius * view.scale,
});

// A ball about the bounds of all surfaces, as src/scene/scene_at.cpp has it.
function ballAboutAll(views) {
    const balls = views.map(ballAbout);
    if (balls.length === 1) return balls[0];
    const end = (k, sign) =>
        sign * Math.max(...balls.map(({ centre, radius }) => sign * centre[k] + radius));
    const centre = [0, 1, 2].map((k) => 0.5 * (end(k, -1) + end(k, 1)));
    const radius = Math.max(...balls.map((ball) => ball.radius + length(sub(ball.centre, centre))));
    return { centre, radius };
}

// The ball touches the nearer edges of the picture.
function fitted(view, aspect, { centre: target, radius }) {
    const narrow = Math.atan(slopeOf(view) * Math.min(aspect, 1));
    const position = sub(target, times(radius / Math.sin(narrow), pictureAxes(view).forward));
    const height = (2 * radius * view.zoom) / (view.fit ?? 1) / Math.min(aspect, 1);
    return usable({ position, target, height }, view);
}

// The axes from which azimuth counts: src/scene/scene_at.cpp.
function orbitAxes(up) {
    const pole = normalized(up);
    let ahead = sub([1, 0, 0], times(pole[0], pole));
    if (length(ahead) < 1e-6) ahead = sub([0, 1, 0], times(pole[1], pole));
    ahead = normalized(ahead);
    return { pole, ahead, left: cross(pole, ahead) };
}

// A camera as angles about its target, and back.
function anglesOf(view) {
    const { pole, ahead, left } = orbitAxes(view.up);
    const back = sub(view.position, view.target);
    const distance = length(back);
    const degrees = (angle) => (angle * 180) / Math.PI;
    return {
        azimuth: degrees(Math.atan2(dot(back, left), dot(back, ahead))),
        elevation: degrees(Math.asin(clamp(dot(back, pole) / distance, -1, 1))),
        distance,
    };
}

function cameraAt({ azimuth, elevation, distance, target, height, up }) {
    const { pole, ahead, left } = orbitAxes(up);
    const a = radians(azimuth), e = radians(elevation);
    const level = add(times(Math.cos(a), ahead), times(Math.sin(a), left));
    const direction = add(times(Math.cos(e), level), times(Math.sin(e), pole));
    return { position: add(target, times(distance, direction)), target, height };
}

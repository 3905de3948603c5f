// From a camera to the block Frame: src/scene/rays.cpp, src/scene/ray_rounding.cpp and
// src/render/uniform_blocks.cpp in the same arithmetic, doubles, so that frames are those of `render`.

// `view.fit`: how many times as high the picture is as the scene has it, so that a window that is
// higher than wide shows the whole of it.
function raysOf(view, width, height, aim = [0, 0, 0, 0]) {
    const toLocal = (v) => turnedBack(view.rotate, v);
    const eye = times(1 / view.scale, toLocal(sub(view.position, view.translate)));
    const forward = normalized(toLocal(sub(view.target, view.position)));
    let up = toLocal(view.up);
    // A camera that looks along its own `up` still has an upright picture.
    if (length(cross(forward, up)) < 1e-9 * length(up))
        up = Math.abs(forward[0]) < 0.9 ? [1, 0, 0] : [0, 1, 0];
    const right = normalized(cross(forward, up));
    up = cross(right, forward);
    const depth = Math.max(dot(sub(view.centre, eye), forward), 0.5 * view.radius);
    const shown = view.parallel
        ? (0.5 * view.height) / view.scale
        : depth * Math.tan(radians(view.fov) / 2);
    const halfHeight = (shown / view.zoom) * (view.fit ?? 1);
    const axis = times(depth, forward);
    const rays = {
        parallel: view.parallel,
        axis,
        origin: add(eye, axis),
        up: times(halfHeight, up),
        right: times((halfHeight * width) / height, right),
    };
    return aimed(rays, view, width, height, aim);
}

// `aim`: from the pixel's centre in pixels, and from the lens' middle in radii of the aperture.
function aimed(rays, view, width, height, [x, y, lensX, lensY]) {
    let { axis, origin } = rays;
    if (x !== 0 || y !== 0) {
        const across = add(times((2 * x) / width, rays.right), times((2 * y) / height, rays.up));
        origin = add(origin, across);
        if (!rays.parallel) axis = add(axis, across);
    }
    if (view.aperture > 0 && (lensX !== 0 || lensY !== 0)) {
        const place = times((0.5 * view.aperture) / view.scale,
            add(times(lensX, normalized(rays.right)), times(lensY, normalized(rays.up))));
        // What was straight ahead now lies beside the lens' point, but for what is in focus.
        const beyond = (length(rays.axis) * view.scale) / view.focus;
        origin = add(origin, times(1 - beyond, place));
        axis = sub(axis, times(beyond, place));
    }
    return { ...rays, axis, origin };
}

// How far float32 may carry points of rays that are `depth` from the plane of the anchors.
function rayRounding(rays, view, depth) {
    const unit = 2 ** -24;
    const spread = length(rays.right) + length(rays.up);
    const away = dot(rays.axis, normalized(cross(rays.up, rays.right)));
    const slant = length(rays.axis) / away + (rays.parallel ? 0 : spread / away);
    return 16 * unit * (largest(rays.origin) + spread) + 18 * unit * depth * slant +
        2 * unit * largest(view.centre);
}

function frameBlock(view, settings, width, height, aim) {
    const rays = raysOf(view, width, height, aim);
    const face = rayRounding(rays, view, view.radius);
    const footprint = (2 * length(rays.up)) / height;
    const spacing = 2 ** -21 * view.radius;
    const finest = (part) => Math.max(part * footprint, spacing);
    const eighth = 0.125 * view.radius;
    // A slider may make waves shorter than any frame has them.
    const steps = view.isHeld ? settings.heldSteps : settings.steps;
    return new Float32Array([
        ...rays.origin, 0,
        ...rays.axis, rays.parallel ? 0 : 1,
        ...rays.right, 0,
        ...rays.up, 0,
        ...(view.box ? [...view.min.map((x) => x - face), 0] : [...view.centre, view.radius + face]),
        ...view.max.map((x) => x + face), 0,
        2 / width, 2 / height, 0, 0,
        ...(settings.cubics ? [steps.first * eighth, 0, 0, 0]
            : [settings.step, settings.near, settings.far, settings.horizon]),
        settings.bisections, settings.limit, finest(2 ** -13), eighth,
        settings.safety, Math.min(steps.longest * eighth, 0.5 * view.elementRadius), spacing,
        finest(2 ** -10),
    ]);
}

// Uniform `beam` of shaders/march/beam_by_intervals.glsl, for beams of so many pixels across.
function beamRange(view, width, height, aim, block) {
    const rays = raysOf(view, width, height, aim);
    const forward = normalized(cross(rays.up, rays.right));
    const depth = dot(rays.axis, forward);
    const away = sub(view.centre, rays.origin);
    const middle = dot(away, forward) / depth;
    const half = (1.001 * view.radius) / depth;
    const rounding = rayRounding(rays, view, (Math.abs(middle) + 2 * half) * depth);
    const pixel = (2 * length(rays.up)) / height;
    return [
        rays.parallel ? middle - half : Math.max(middle - half, -1),
        middle + half,
        (0.5 * block * pixel) / depth,
        4 * rounding,
    ];
}

// Uniforms of a surface among several, of which there are these views, that relate its rays and places
// to those of the others: uniforms_among() of src/render/several_surfaces.cpp.
function uniformsAmong(views, index, width, height, aim) {
    const depthOf = (view) => {
        const rays = raysOf(view, width, height, aim);
        return dot(rays.axis, normalized(cross(rays.up, rays.right)));
    };
    const own = views[index], depth = depthOf(own);
    const unit = own.scale / views[0].scale;
    const moves = views.flatMap((view, k) => k === index
        ? [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0] : changeOfPlace(view, own).flat());
    return { surface_way: [unit, (unit * depth - depthOf(views[0])) / depth, 0, 0],
        surface_moves: moves };
}

// Three rows, from the formula coordinates of one surface to those of another.
function changeOfPlace(from, to) {
    const origin = turnedBack(to.rotate, sub(from.translate, to.translate));
    const axes = [0, 3, 6].map((k) => times(from.scale / to.scale,
        turnedBack(to.rotate, from.rotate.slice(k, k + 3))));
    return [0, 1, 2].map((k) => [...axes.map((axis) => axis[k]), origin[k] / to.scale]);
}

// im_noise on intervals. Needs math/noise.glsl, arithmetic.glsl.
//
// src/formula/interval/noise_enclosure.cpp is the same on doubles. `bound` holds everywhere.

// t (1 - t), which rises to 1/4 at 1/2 and falls.
REAL2 im_bump(REAL2 t) {
    precise REAL2 inner = t * (1.0 - t);
    REAL2 ends = REAL2(min(inner.x, inner.y), max(inner.x, inner.y));
    ends = im_not_negative(im_widen(ends, 2.0 * IM_ROUNDING));
    return REAL2(ends.x, IM_SELECT(t.x <= 0.5 && t.y >= 0.5, 0.25, ends.y));
}

// Rises. The number's fade is within 2^-20 of itself: half of that for t up to 1/2, by counting the
// roundings of its terms, and as much beyond, where 1 - t is exact.
REAL2 im_fade(REAL2 t) {
    REAL2 ends = im_widen(REAL2(im_fade(t.x), im_fade(t.y)), 9.53674316e-7);
    return clamp(ends, 0.0, 1.0);
}

REAL2 im_fade(REAL2 t, int order) {
    REAL2 slant = im_subtract(REAL2(1.0), 2.0 * t);
    if (order == 0) return im_fade(t);
    if (order == 1) return im_scale_up(30.0, im_square(im_bump(t)));
    if (order == 2) return im_multiply(im_scale_up(60.0, im_bump(t)), slant);
    if (order == 3) return im_subtract(REAL2(60.0), im_scale_up(360.0, im_bump(t)));
    if (order == 4) return im_scale(-360.0, slant);
    return REAL2(order == 5 ? 720.0 : 0.0);
}

struct NoiseWeights {
    REAL2 a0, a1, b0, b1; // of values and of slopes, at both corners along an axis
};

NoiseWeights im_noise_weights(REAL2 t, int order) {
    NoiseWeights w;
    w.a1 = im_fade(t, order);
    w.a0 = order == 0 ? im_subtract(REAL2(1.0), w.a1) : -w.a1.yx;
    w.b0 = im_multiply(w.a0, t);
    w.b1 = im_multiply(w.a1, im_subtract(t, REAL2(1.0)));
    if (order > 0) {
        REAL2 lower = im_fade(t, order - 1);
        REAL2 less = order == 1 ? im_subtract(REAL2(1.0), lower) : -lower.yx;
        w.b0 = im_add(w.b0, im_scale_up(REAL(order), less));
        w.b1 = im_add(w.b1, im_scale_up(REAL(order), lower));
    }
    return w;
}

// s is -1, 0 or 1.
REAL2 im_signed(REAL s, REAL2 a) {
    return s < 0.0 ? -a.yx : s * a;
}

// What a corner adds, and the linear function that is its own.
void im_noise_corner(uvec3 corner, vec3 far, NoiseWeights u, NoiseWeights v, NoiseWeights w,
                     REAL2 x, REAL2 y, REAL2 z, inout REAL2 sum, inout REAL2 hull) {
    vec3 g = im_noise_gradient(corner);
    REAL2 ax = IM_SELECT2(far.x > 0.0, u.a1, u.a0), bx = IM_SELECT2(far.x > 0.0, u.b1, u.b0);
    REAL2 ay = IM_SELECT2(far.y > 0.0, v.a1, v.a0), by = IM_SELECT2(far.y > 0.0, v.b1, v.b0);
    REAL2 az = IM_SELECT2(far.z > 0.0, w.a1, w.a0), bz = IM_SELECT2(far.z > 0.0, w.b1, w.b0);
    REAL2 along_x = im_multiply(im_multiply(bx, ay), az);
    REAL2 along_y = im_multiply(im_multiply(ax, by), az);
    REAL2 along_z = im_multiply(im_multiply(ax, ay), bz);
    sum = im_add(sum, im_add(im_add(im_signed(g.x, along_x), im_signed(g.y, along_y)),
                             im_signed(g.z, along_z)));
    REAL2 dx = im_subtract(x, REAL2(far.x));
    REAL2 dy = im_subtract(y, REAL2(far.y));
    REAL2 dz = im_subtract(z, REAL2(far.z));
    hull = im_hull(hull,
                   im_add(im_add(im_signed(g.x, dx), im_signed(g.y, dy)), im_signed(g.z, dz)));
}

// The loop keeps the shader short, which takes a driver seconds to compile otherwise. Loops have a
// limit for all of a shader: src/shader/loop_limit.h counts their turns.
REAL2 im_noise_in_cell(vec3 cell, REAL2 x, REAL2 y, REAL2 z, ivec3 order) {
    NoiseWeights u = im_noise_weights(x, order.x);
    NoiseWeights v = im_noise_weights(y, order.y);
    NoiseWeights w = im_noise_weights(z, order.z);
    uvec3 first = im_lattice_point(cell);
    REAL2 sum = REAL2(0.0), hull = REAL2(IM_INFINITY, -IM_INFINITY);
    for (uint c = 0u; c < 8u; ++c) {
        uvec3 far = uvec3(c & 1u, c >> 1 & 1u, c >> 2);
        im_noise_corner(first + far, vec3(far), u, v, w, x, y, z, sum, hull);
    }
    // Noise is a mean of the corners' linear functions.
    return order == ivec3(0) ? REAL2(max(sum.x, hull.x), min(sum.y, hull.y)) : sum;
}

REAL2 im_noise(REAL2 x, REAL2 y, REAL2 z, ivec3 order, REAL bound) {
    vec3 first = floor(vec3(x.x, y.x, z.x)), last = floor(vec3(x.y, y.y, z.y));
    REAL2 anywhere = REAL2(-bound, bound);
    // Others hold too many cells, or lie where floats have no fractions.
    bool is_small = all(lessThan(last - first, vec3(1.5))) &&
                    all(lessThan(max(abs(first), abs(last)), vec3(8388608.0)));
    if (!is_small) return anywhere;
    REAL2 found = REAL2(IM_INFINITY, -IM_INFINITY);
    ivec3 cells = ivec3(last - first) + 1;
    for (int n = 0; n < cells.x * cells.y * cells.z; ++n) {
        int row = n / cells.x;
        vec3 cell = first + vec3(ivec3(n - row * cells.x, row % cells.y, row / cells.y));
        REAL2 u = clamp(im_subtract(x, REAL2(cell.x)), 0.0, 1.0);
        REAL2 v = clamp(im_subtract(y, REAL2(cell.y)), 0.0, 1.0);
        REAL2 w = clamp(im_subtract(z, REAL2(cell.z)), 0.0, 1.0);
        found = im_hull(found, im_noise_in_cell(cell, u, v, w, order));
    }
    return REAL2(max(found.x, anywhere.x), min(found.y, anywhere.y));
}

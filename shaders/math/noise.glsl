// im_noise. Needs no other file. src/formula/graph/noise.h defines it.

// The lattice repeats, so that its points are whole numbers in 20 bits.
uvec3 im_lattice_point(vec3 whole) {
    return uvec3(ivec3(whole - 1048576.0 * floor(whole / 1048576.0)));
}

// Components of -1, 0 and 1; one is 0.
vec3 im_noise_gradient(uvec3 at) {
    at &= 1048575u;
    uint h = at.x * 0x9E3779B1u ^ at.y * 0x85EBCA77u ^ at.z * 0xC2B2AE3Du;
    h = (h ^ h >> 15) * 0x2C1B3C6Du;
    h = (h ^ h >> 12) * 0x297A2D39u;
    h ^= h >> 15;
    uint across = (h >> 16) * 3u >> 16;
    float s = (h & 1u) != 0u ? -1.0 : 1.0;
    float t = (h & 2u) != 0u ? -1.0 : 1.0;
    return vec3(across == 0u ? 0.0 : s, across == 0u ? s : (across == 1u ? 0.0 : t),
                across == 2u ? 0.0 : t);
}

// 10t^3 - 15t^4 + 6t^5, for t up to 1/2.
float im_fade_low(float t) {
    precise float y = t * t * t * (10.0 - t * (15.0 - 6.0 * t));
    return y;
}

float im_fade(float t) {
    precise float high = 1.0 - im_fade_low(1.0 - t);
    return IM_SELECT(t > 0.5, high, im_fade_low(t));
}

float im_fade(float t, int order) {
    float s = t * (1.0 - t), slant = 1.0 - 2.0 * t;
    return order == 0   ? im_fade(t)
           : order == 1 ? 30.0 * s * s
           : order == 2 ? 60.0 * s * slant
           : order == 3 ? 60.0 - 360.0 * s
           : order == 4 ? -360.0 * slant
           : order == 5 ? 720.0
                        : 0.0;
}

// The weights of both corners along an axis: of values in `a`, of slopes in `b`.
void im_noise_weights(float t, int order, out vec2 a, out vec2 b) {
    float far = im_fade(t, order);
    a = vec2(order == 0 ? im_fade(1.0 - t) : -far, far);
    b = vec2(t, t - 1.0) * a;
    float lower = order == 0 ? 0.0 : im_fade(t, order - 1);
    if (order > 0) b += float(order) * vec2(order == 1 ? 1.0 - lower : -lower, lower);
}

float im_noise(float x, float y, float z, ivec3 order) {
    vec3 whole = floor(vec3(x, y, z));
    precise vec3 t = vec3(x, y, z) - whole;
    uvec3 cell = im_lattice_point(whole);
    vec2 ax, ay, az, bx, by, bz;
    im_noise_weights(t.x, order.x, ax, bx);
    im_noise_weights(t.y, order.y, ay, by);
    im_noise_weights(t.z, order.z, az, bz);
    float sum = 0.0;
    for (uint k = 0u; k < 2u; ++k) {
        float a = k == 0u ? az.x : az.y, b = k == 0u ? bz.x : bz.y;
        // The slopes along x, y and z of the corners (0, 0), (1, 0), (0, 1) and (1, 1) of a face.
        vec3 g = im_noise_gradient(cell + uvec3(0u, 0u, k));
        sum += (g.x * bx.x * ay.x + g.y * ax.x * by.x) * a + g.z * ax.x * ay.x * b;
        g = im_noise_gradient(cell + uvec3(1u, 0u, k));
        sum += (g.x * bx.y * ay.x + g.y * ax.y * by.x) * a + g.z * ax.y * ay.x * b;
        g = im_noise_gradient(cell + uvec3(0u, 1u, k));
        sum += (g.x * bx.x * ay.y + g.y * ax.x * by.y) * a + g.z * ax.x * ay.y * b;
        g = im_noise_gradient(cell + uvec3(1u, 1u, k));
        sum += (g.x * bx.y * ay.y + g.y * ax.y * by.y) * a + g.z * ax.y * ay.y * b;
    }
    return sum;
}

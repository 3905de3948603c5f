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

// The weights of both corners along an axis: of values in x, of slopes in y.
void im_noise_weights(float t, int order, out vec2 near, out vec2 far) {
    far.x = im_fade(t, order);
    near.x = order == 0 ? im_fade(1.0 - t) : -far.x;
    near.y = t * near.x;
    far.y = (t - 1.0) * far.x;
    if (order > 0) {
        float lower = im_fade(t, order - 1);
        near.y += float(order) * (order == 1 ? 1.0 - lower : -lower);
        far.y += float(order) * lower;
    }
}

float im_noise_of_corner(uvec3 corner, vec2 x, vec2 y, vec2 z) {
    vec3 slope = im_noise_gradient(corner);
    return (slope.x * x.y * y.x + slope.y * x.x * y.y) * z.x + slope.z * x.x * y.x * z.y;
}

float im_noise(float x, float y, float z, ivec3 order) {
    vec3 whole = floor(vec3(x, y, z));
    precise vec3 t = vec3(x, y, z) - whole;
    uvec3 cell = im_lattice_point(whole);
    vec2 x0, x1, y0, y1, z0, z1;
    im_noise_weights(t.x, order.x, x0, x1);
    im_noise_weights(t.y, order.y, y0, y1);
    im_noise_weights(t.z, order.z, z0, z1);
    float sum = 0.0;
    for (uint k = 0u; k < 2u; ++k) {
        vec2 zk = k == 0u ? z0 : z1;
        sum += im_noise_of_corner(cell + uvec3(0u, 0u, k), x0, y0, zk);
        sum += im_noise_of_corner(cell + uvec3(1u, 0u, k), x1, y0, zk);
        sum += im_noise_of_corner(cell + uvec3(0u, 1u, k), x0, y1, zk);
        sum += im_noise_of_corner(cell + uvec3(1u, 1u, k), x1, y1, zk);
    }
    return sum;
}

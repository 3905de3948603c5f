// The beam of a block of BLOCK x BLOCK pixels, and boxes around pieces of it.
//
// Depths are tau: the ray that crosses the plane of the anchors at `across` (from ray_origin) is at
// ray_origin + tau ray_axis + (1 + w tau) across, with w = 1, or 0 for parallel rays.

#ifdef BOX
vec3 bounds_low() { return bounds_min.xyz - beam.w; }
vec3 bounds_high() { return bounds_max.xyz + beam.w; }

bool meets_bounds(vec2 x, vec2 y, vec2 z) {
    vec3 a = bounds_low(), b = bounds_high();
    return x.x <= b.x && x.y >= a.x && y.x <= b.y && y.y >= a.y && z.x <= b.z && z.y >= a.z;
}
#else
vec3 bounds_low() { return bounds_min.xyz - (bounds_min.w + beam.w); }
vec3 bounds_high() { return bounds_min.xyz + (bounds_min.w + beam.w); }

bool meets_bounds(vec2 x, vec2 y, vec2 z) {
    vec3 c = bounds_min.xyz;
    vec3 off = max(max(vec3(x.x, y.x, z.x) - c, c - vec3(x.y, y.y, z.y)), 0.0);
    float reach = (bounds_min.w + beam.w) * (1.0 + 1.0e-6);
    return dot(off, off) <= reach * reach;
}
#endif

vec2 hull(float a, float b) {
    return vec2(min(a, b), max(a, b));
}

// The factors [a, b] times an interval, 0 <= a <= b.
vec2 scaled(float a, float b, vec2 x) {
    return vec2(min(a * x.x, b * x.x), max(a * x.y, b * x.y));
}

struct Beam {
    vec3 low, high; // range of `across`
};

// The part of its length that a beam has to search.
struct Part {
    float low, high; // tau
    float first;     // length of the piece to try first
#ifdef LISTS
    // The lists of elements for depths up to front_end, and for all depths.
    float front_end;
    LIST front, all;
#endif
};

// Widens the block beyond the middles of its outer pixels, in pixels: rays may be anywhere in
// blocks of a light's picture.
uniform float around_middles;

Beam beam_of(ivec2 block) {
    vec2 first = (vec2(block * BLOCK) + picture.zw + 0.5) * picture.xy - 1.0;
    vec2 half_size = 0.5 * float(BLOCK - 1) * picture.xy;
    vec2 middle = first + half_size;
    vec3 across = middle.x * ray_right.xyz + middle.y * ray_up.xyz;
    half_size += around_middles * picture.xy;
    vec3 reach = abs(half_size.x * ray_right.xyz) + abs(half_size.y * ray_up.xyz);
    return Beam(across - reach, across + reach);
}

// Encloses the beam between depths a and b in a box.
void box_around(Beam way, float a, float b, out vec2 x, out vec2 y, out vec2 z) {
    float near = max(1.0 + ray_axis.w * a, 0.0), far = max(1.0 + ray_axis.w * b, 0.0);
    vec2 rounding = vec2(-beam.w, beam.w);
    x = ray_origin.x + hull(a * ray_axis.x, b * ray_axis.x) +
        scaled(near, far, vec2(way.low.x, way.high.x)) + rounding;
    y = ray_origin.y + hull(a * ray_axis.y, b * ray_axis.y) +
        scaled(near, far, vec2(way.low.y, way.high.y)) + rounding;
    z = ray_origin.z + hull(a * ray_axis.z, b * ray_axis.z) +
        scaled(near, far, vec2(way.low.z, way.high.z)) + rounding;
}

// The same box within the bounds. False if it lies outside of them.
bool box_of(Beam way, float a, float b, out vec2 x, out vec2 y, out vec2 z) {
    box_around(way, a, b, x, y, z);
    bool meets = meets_bounds(x, y, z);
    vec3 least = bounds_low(), most = bounds_high();
    if (meets) {
        x = vec2(max(x.x, least.x), min(x.y, most.x));
        y = vec2(max(y.x, least.y), min(y.y, most.y));
        z = vec2(max(z.x, least.z), min(z.y, most.z));
    }
    return meets;
}

// The part of a block's beam that is searched.
#ifdef PARENT_BLOCK
// What larger beams, PARENT_BLOCK pixels across, left of it.
Part parent_part(ivec2 block) {
    ivec2 at = beam_texel(block * BLOCK / PARENT_BLOCK, PARENT_SQUARE_BITS);
    vec4 part = part_of_beam(at);
#ifdef LISTS
#ifdef COPIES
    ivec2 larger = block * BLOCK / PARENT_BLOCK;
    LIST front = list_of_larger(larger, 0), all = list_of_larger(larger, 1);
#else
    LIST front = front_of_beam(at), all = all_of_beam(at);
#endif
    return Part(part.x, part.y, 2.0 * beam.z, part.z, front, all);
#else
    return Part(part.x, part.y, 2.0 * beam.z);
#endif
}
#else
// All of the bounds.
Part parent_part(ivec2 block) {
    float first = 0.125 * (beam.y - beam.x);
#ifdef LISTS
    LIST all = entered_list();
    return Part(beam.x, beam.y, first, beam.y, all, all);
#else
    return Part(beam.x, beam.y, first);
#endif
}
#endif

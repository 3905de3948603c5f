// Light from the environment, by direction. Needs math/inverse_trig.glsl.
//
// environment_map is a latitude-longitude map whose row 0 is the top. Since texelFetch alone reads
// it, this file filters it: bilinearly, across the seam in longitude, and with the first and last
// rows extended to the poles.
uniform sampler2D environment_map;
// Directions of the map's middle, left quarter and top: unit length, formula coordinates.
uniform vec3 environment_ahead;
uniform vec3 environment_left;
uniform vec3 environment_top;
uniform float environment_intensity;

// Angle of v in turns, -1/2 to 1/2; 0 for a zero vector. GLSL allows atan(y, x) an error of 4096
// ulp, a texel of a large map.
float turns(vec2 v) {
    vec2 size = abs(v);
    float low = min(size.x, size.y);
    float high = max(size.x, size.y);
    float turn = high > 0.0 ? im_atan(low / high) * 0.15915494 : 0.0;
    turn = size.y > size.x ? 0.25 - turn : turn;
    turn = v.x < 0.0 ? 0.5 - turn : turn;
    return v.y < 0.0 ? -turn : turn;
}

// Coordinates of a direction in maps, from their top left to their bottom right. `direction`:
// formula coordinates, unit length.
vec2 environment_place(vec3 direction) {
    vec3 d = vec3(dot(environment_ahead, direction), dot(environment_left, direction),
                  dot(environment_top, direction));
    // Uses the angle from the top, since asin(d.z) has no digits left near the poles.
    return vec2(0.5 - turns(d.xy), 2.0 * turns(vec2(d.z, length(d.xy))));
}

vec3 environment_texel(sampler2D map, int column, int row) {
    return texelFetch(map, ivec2(column, row), 0).rgb;
}

// Reads the map of this size that begins in row `top` of a texture.
vec3 environment_filtered(sampler2D map, int top, ivec2 size, vec2 place) {
    vec2 at = place * vec2(size) - 0.5;
    vec2 corner = floor(at);
    vec2 part = at - corner;
    int left = int(corner.x) < 0 ? size.x - 1 : int(corner.x);
    int right = left + 1 < size.x ? left + 1 : 0;
    int above = top + max(int(corner.y), 0);
    int below = top + min(int(corner.y) + 1, size.y - 1);
    vec3 upper = mix(environment_texel(map, left, above), environment_texel(map, right, above),
                     part.x);
    vec3 lower = mix(environment_texel(map, left, below), environment_texel(map, right, below),
                     part.x);
    return mix(upper, lower, part.y);
}

vec3 environment(vec3 direction) {
    ivec2 size = textureSize(environment_map, 0);
    return environment_intensity *
           environment_filtered(environment_map, 0, size, environment_place(direction));
}

#ifdef FOOTPRINT
// The environment seen in a rough mirror.
//
// environment_levels holds eight blurred maps one below the other, each half as wide as the one
// above it and at least 32 texels wide. Level k is the map blurred by GGX's lobe of alpha 2^k / 256
// (image/environment_levels.h). Level 0 is the map itself.
uniform sampler2D environment_levels;

vec3 environment_level(int level, vec2 place) {
    if (level == 0) {
        return environment_filtered(environment_map, 0, textureSize(environment_map, 0), place);
    }
    int top = 0;
    int width = textureSize(environment_levels, 0).x;
    for (int k = 1; k < level; ++k) {
        top += width / 2;
        width = max(width / 2, 32);
    }
    return environment_filtered(environment_levels, top, ivec2(width, width / 2), place);
}

vec3 rough_environment(vec3 direction, float alpha2) {
    float level = clamp(0.5 * log2(alpha2) + 8.0, 0.0, 8.0);
    int lower = min(int(level), 7);
    float part = level - float(lower);
    vec2 place = environment_place(direction);
    vec3 sum = vec3(0.0);
    // A loop, since drivers inline each call.
    for (int k = 0; k < 2; ++k) {
        float weight = k == 0 ? 1.0 - part : part;
        if (weight > 0.0) sum += weight * environment_level(lower + k, place);
    }
    return environment_intensity * sum;
}
#endif

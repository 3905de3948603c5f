// Light from far away, by direction. Needs math/inverse_trig.glsl.
//
// environment_map is a latitude-longitude map, row 0 the top one. As texelFetch alone reads it, the
// texel is filtered here: bilinear, round the back in longitude, its first and last row up to the
// poles.
uniform sampler2D environment_map;
// Where the map has its middle, its left quarter and its top: unit length, formula coordinates.
uniform vec3 environment_ahead;
uniform vec3 environment_left;
uniform vec3 environment_top;
uniform float environment_intensity;

// The angle of v in turns, -1/2 to 1/2; 0 for no direction. GLSL lets atan(y, x) be off by 4096
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

// Where a direction is in maps, from their top left to their bottom right. `direction` in formula
// coordinates, of unit length.
vec2 environment_place(vec3 direction) {
    vec3 d = vec3(dot(environment_ahead, direction), dot(environment_left, direction),
                  dot(environment_top, direction));
    // The angle from the top, not asin(d.z), which has no digits left near the poles.
    return vec2(0.5 - turns(d.xy), 2.0 * turns(vec2(d.z, length(d.xy))));
}

vec3 environment_texel(sampler2D map, int column, int row) {
    return texelFetch(map, ivec2(column, row), 0).rgb;
}

// The map of this size that begins in row `top` of a texture.
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

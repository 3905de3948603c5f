// The environment seen in a rough mirror. Needs effects/environment.glsl.
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

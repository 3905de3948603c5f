// Shadow rays go on for the lights that no surface before this one hides, of which shadow_texture tells.
uniform sampler2D shadow_texture;

RayState begin_lights() {
    RayState s = state_at(0.0);
    vec4 others = texelFetch(shadow_texture, ivec2(pixel_centre), 0);
    s.verdict = int(others.y) + UNDECIDED_RAY * int(others.w);
    s.evaluations = int(others.z);
    return s;
}

int evaluations_before() {
    return int(texelFetch(shadow_texture, ivec2(pixel_centre), 0).z);
}

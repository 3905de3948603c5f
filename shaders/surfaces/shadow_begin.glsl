// Shadow rays go on for the lights that no surface before this one hides, of which shadow_texture tells.
uniform sampler2D shadow_texture;

RayState after_others(float t) {
    RayState s = state_at(t);
    vec4 others = texelFetch(shadow_texture, ivec2(pixel_centre), 0);
    s.verdict = int(others.y);
    s.evaluations = int(others.z);
    return s;
}

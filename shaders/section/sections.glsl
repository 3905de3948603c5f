// Sections: half-spaces and balls that are taken away from the solid F < 0. SECTIONS is their number,
// SECTION_BALLS has a bit for each that is a ball. What is left has a surface of two kinds: where F
// is 0 outside of all sections, and caps, where a section's own surface lies in F < 0.

// A half-space is its unit normal and how far along that it begins, a ball its centre and radius.
// Formula coordinates.
uniform vec4 sections[SECTIONS];

bool is_ball(int k) {
    return ((SECTION_BALLS >> k) & 1) != 0;
}

// Above 0 in what section k takes away: a distance, but within a ball.
float section_value(int k, vec3 p) {
    vec4 s = sections[k];
    return is_ball(k) ? s.w - distance(s.xyz, p) : dot(s.xyz, p) - s.w;
}

// Towards what it takes away, unit length.
vec3 section_gradient(int k, vec3 p) {
    vec4 s = sections[k];
    vec3 inwards = s.xyz - p;
    return is_ball(k) ? inwards / max(length(inwards), 1.0e-30) : s.xyz;
}

// Mean and Gaussian curvature, of the side towards what is taken away.
vec2 section_curvatures(int k) {
    float r = sections[k].w;
    return is_ball(k) ? vec2(-1.0 / r, 1.0 / (r * r)) : vec2(0.0);
}

// Above 0 where any section takes the place away.
float sections_value(vec3 p) {
    float most = -1.0e30;
    for (int k = 0; k < SECTIONS; ++k) most = max(most, section_value(k, p));
    return most;
}

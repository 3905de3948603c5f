// Sections: SECTIONS half-spaces and balls that are taken away from the solid F < 0. SECTION_BALLS
// has a bit for each ball. The remaining solid has two kinds of surface: places outside of all
// sections where F is 0, and caps, the parts of a section's own surface where F < 0.

// A half-space: its unit normal and where along that it begins. A ball: its centre and radius.
// Formula coordinates.
uniform vec4 sections[SECTIONS];

bool is_ball(int k) {
    return ((SECTION_BALLS >> k) & 1) != 0;
}

// Positive inside section k, the part taken away. A distance, except inside a ball.
float section_value(int k, vec3 p) {
    vec4 s = sections[k];
    return is_ball(k) ? s.w - distance(s.xyz, p) : dot(s.xyz, p) - s.w;
}

// Unit gradient of section_value(), into the part taken away.
vec3 section_gradient(int k, vec3 p) {
    vec4 s = sections[k];
    vec3 inwards = s.xyz - p;
    return is_ball(k) ? inwards / max(length(inwards), 1.0e-30) : s.xyz;
}

// Mean and Gaussian curvature, for the normal into the part taken away.
vec2 section_curvatures(int k) {
    float r = sections[k].w;
    return is_ball(k) ? vec2(-1.0 / r, 1.0 / (r * r)) : vec2(0.0);
}

// Positive where any section takes the point away.
float sections_value(vec3 p) {
    float most = -1.0e30;
    for (int k = 0; k < SECTIONS; ++k) most = max(most, section_value(k, p));
    return most;
}

#ifdef BEAM_BOXES
// Returns the least and largest sections_value() over a box, with rounding.
vec2 sections_over(vec2 x, vec2 y, vec2 z, float rounding) {
    vec2 most = vec2(-1.0e30);
    vec3 low = vec3(x.x, y.x, z.x), high = vec3(x.y, y.y, z.y);
    for (int k = 0; k < SECTIONS; ++k) {
        vec4 s = sections[k];
        vec2 value;
        if (is_ball(k)) {
            vec3 nearest = clamp(s.xyz, low, high) - s.xyz;
            vec3 farthest = max(abs(low - s.xyz), abs(high - s.xyz));
            value = s.w - vec2(length(farthest), length(nearest));
        } else {
            vec3 a = s.xyz * low, b = s.xyz * high;
            value = vec2(dot(min(a, b), vec3(1.0)), dot(max(a, b), vec3(1.0))) - s.w;
        }
        most = max(most, value);
    }
    return most + vec2(-rounding, rounding);
}
#endif

// Returns the least and largest sections_value() over a box, with rounding. Needs sections.glsl.
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

// Sequential colour map: a straight line through OKLab from dark blue to light yellow. Steps are
// equal and lightness grows evenly; blue and yellow differ without red and green. Needs oklab.glsl.
vec3 color_map(float u) {
    return from_oklab(mix(vec3(0.32, -0.012, -0.13), vec3(0.93, -0.055, 0.15), u));
}

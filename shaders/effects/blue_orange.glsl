// Diverging colour map: two straight lines through OKLab, from blue and from orange to the white
// between them, equally long and equally steep in lightness. Needs oklab.glsl.
vec3 color_map(float u) {
    vec3 end = u < 0.5 ? vec3(0.5, -0.025, -0.114) : vec3(0.5, 0.067, 0.0956);
    return from_oklab(mix(vec3(0.96, 0.0, 0.0), end, abs(2.0 * u - 1.0)));
}

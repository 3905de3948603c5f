// Maps of colours: color_map() of a number from 0 to 1.

// Converts OKLab (Ottosson 2020: lightness, green to red, blue to yellow) to linear sRGB. Equal
// distances in OKLab look equally different.
vec3 from_oklab(vec3 lab) {
    vec3 lms = lab.x + vec3(0.3963377774 * lab.y + 0.2158037573 * lab.z,
                            -0.1055613458 * lab.y - 0.0638541728 * lab.z,
                            -0.0894841775 * lab.y - 1.2914855480 * lab.z);
    lms = lms * lms * lms;
    return vec3(dot(lms, vec3(4.0767416621, -3.3077115913, 0.2309699292)),
                dot(lms, vec3(-1.2684380046, 2.6097574011, -0.3413193965)),
                dot(lms, vec3(-0.0041960863, -0.7034186147, 1.7076147010)));
}

#ifdef BLUE_YELLOW
// Sequential colour map: a straight line through OKLab from dark blue to light yellow. Steps are
// equal and lightness grows evenly; blue and yellow differ without red and green.
vec3 color_map(float u) {
    return from_oklab(mix(vec3(0.32, -0.012, -0.13), vec3(0.93, -0.055, 0.15), u));
}
#else
// Diverging colour map: two straight lines through OKLab, from blue and from orange to the white
// between them, equally long and equally steep in lightness.
vec3 color_map(float u) {
    vec3 end = u < 0.5 ? vec3(0.5, -0.025, -0.114) : vec3(0.5, 0.067, 0.0956);
    return from_oklab(mix(vec3(0.96, 0.0, 0.0), end, abs(2.0 * u - 1.0)));
}
#endif

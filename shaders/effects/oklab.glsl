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

// Gives caps a colour of their own.
uniform vec4 cap_color;

vec3 surface_color(Hit hit) {
    return hit.cap >= 0 ? cap_color.rgb : color_below(hit);
}

// Evaluates the colour at a point on the side where F > 0.
uniform vec4 inside_color; // of the side where F < 0

vec3 surface_color(Hit hit) {
    return hit.inside ? inside_color.rgb : color_by_place(hit);
}

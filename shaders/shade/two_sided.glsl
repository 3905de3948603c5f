// A colour for each side of the surface.
uniform vec4 inside_color; // of the side where F < 0

vec3 surface_color(Hit hit) {
    return hit.inside ? inside_color.rgb : material_color.rgb;
}

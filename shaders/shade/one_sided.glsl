vec3 surface_color(Hit hit) {
    return material_color.rgb;
}

vec3 surface_color(Hit hit) {
    return color_by_place(hit);
}

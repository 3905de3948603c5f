// Evaluates the material's colour at a point. Needs color_value() and a file with curvatures().
vec3 color_by_place(Hit hit) {
    vec3 rising = hit.inside ? -hit.normal : hit.normal; // towards F > 0
    vec3 n = normalize(mat3(to_world) * rising);
    return color_value(hit.position, n, curvatures(hit), float(load_state().evaluations),
                       material_color.rgb);
}

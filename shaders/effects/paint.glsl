// Colours a point by expressions of the place: by a number on a map of colours, or by a colour. Needs
// curvatures(), what is generated from the expressions, and for a number color_map().
#ifdef PAINT
uniform vec2 paint_range; // numbers at the ends of the map

vec3 painted_color(Hit hit) {
    vec3 rising = hit.inside ? -hit.normal : hit.normal; // towards F > 0
    vec3 n = normalize(mat3(to_world) * rising);
    float value = paint_value(hit.position, n, curvatures(hit), float(load_state().evaluations));
    float u = (value - paint_range.x) / (paint_range.y - paint_range.x);
    // NaN is grey, darker than the greys near the middle of a map.
    return im_is_nan(u) ? vec3(0.05) : color_map(clamp(u, 0.0, 1.0));
}
#else
vec3 painted_color(Hit hit) {
    vec3 rising = hit.inside ? -hit.normal : hit.normal; // towards F > 0
    vec3 n = normalize(mat3(to_world) * rising);
    return color_value(hit.position, n, curvatures(hit), float(load_state().evaluations),
                       material_color.rgb);
}
#endif

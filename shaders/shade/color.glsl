// The colour of a surface: of its matter, and over it those of caps and of contours.
#ifdef TWO_SIDES
uniform vec4 inside_color; // of the side where F < 0
#endif
#ifdef CAP_COLOR
uniform vec4 cap_color;
#endif

vec3 matter_color(Hit hit) {
#if defined(PAINT) || defined(COLOR_BY_PLACE)
    vec3 color = painted_color(hit);
#else
    vec3 color = material_color.rgb;
#endif
#ifdef TWO_SIDES
    return hit.inside ? inside_color.rgb : color;
#else
    return color;
#endif
}

vec3 surface_color(Hit hit) {
    vec3 color = matter_color(hit);
#ifdef CAP_COLOR
    color = hit.cap >= 0 ? cap_color.rgb : color;
#endif
#ifdef CONTOURS
    color = mix(color, contour_color.rgb, on_contours(hit.position, hit.normal));
#endif
    return color;
}

// Where F may jump, have a pole or lack a value there is no root, whatever its sign does: methods
// that bound F pass the shortest piece around such a place, and begin anew behind it.

// (jumps, without value): the entire line where F may not be continuous; above 0 where it has no
// value anywhere.
vec4 breaks_over(Ray ray, vec2 piece) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    return field_breaks(x, y, z);
}

bool may_break(Ray ray, vec2 piece) {
    return !(breaks_over(ray, piece).x > -IM_LARGEST);
}

bool has_no_value(Ray ray, vec2 piece) {
    return breaks_over(ray, piece).z > 0.0;
}

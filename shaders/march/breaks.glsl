// Finds where F may jump, have a pole or lack a value. No root is there, whatever its sign does.
// Methods that bound F pass the shortest piece around such a point, and restart behind it.

// (jumps, without value): the first interval is the entire line if F may not be continuous; the
// second is above 0 if F has no value anywhere in the piece, or no zero beside its poles.
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

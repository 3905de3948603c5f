// Of fields without long sums.
struct Scale {
    float unused;
};

Scale no_scale() {
    return Scale(0.0);
}

vec2 bound_of_field(vec2 x, vec2 y, vec2 z, out Scale scale) {
    scale = no_scale();
    return field_interval(x, y, z);
}

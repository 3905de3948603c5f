// Marching points: the base step everywhere.
float step_size(vec2 f) {
    return thresholds.x;
}

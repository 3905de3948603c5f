// Whether a box lies within the bounds. Needs inside_bounds().
bool holds_within_bounds(vec2 x, vec2 y, vec2 z) {
    bool holds = true;
    for (int k = 0; k < 8; ++k) {
        holds = holds && inside_bounds(vec3((k & 1) == 0 ? x.x : x.y, (k & 2) == 0 ? y.x : y.y,
                                            (k & 4) == 0 ? z.x : z.y));
    }
    return holds;
}

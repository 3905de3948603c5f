// What bounds say where cubics take F for 0 without a change of sign. They tell q^2 - l^3 beside its
// cuspidal edge, where q is 0 and l below it, from 0, when samples of F near q = 0 are all noise.

vec2 bounds_of_value(Ray ray, vec2 piece) {
    vec2 x, y, z;
    box_over(ray, piece, x, y, z);
    return field_interval(x, y, z);
}

// Whether F may be 0 in the piece, down to the shortest parts of it; false where nobody asks.
bool may_be_0(bool asks, Ray ray, vec2 piece, float shortest) {
    float begin = piece.x, length = piece.y - piece.x;
    bool found = false, searches = asks;
    int tries = 0;
    // Software renderers skip loops, but no branches.
    while (searches) {
        bool free = excludes_0(bounds_of_value(ray, vec2(begin, begin + length)));
        found = !free && length <= shortest;
        if (free) begin += length;
        length = free ? 2.0 * length : max(0.5 * length, shortest);
        tries += 1;
        found = found || tries == 64;
        searches = !found && begin < piece.y;
    }
    return found;
}

// Lists the elements of the array that matter in a beam. F is factor * sum + rest, so at a root the
// sum is as large as rest / factor. Elements are left out if their terms, bounded in pieces of the
// beam and all together, stay below LEFT_OUT of that. Float32 loses as much when it adds up some
// ten terms.

// The elements of the whole beam, and of its front, which ends at a depth.
struct Lists {
    KEPT all, front;
    float front_end;
};

Lists lists_of(ivec2 block, Beam way, float low, float high) {
    // Loops must end before drivers end them silently.
    int pieces = clamp(MOST_TERMS / max(array0_count, 1), 1, PIECES);
    int front_pieces = min(FRONT_PIECES, pieces);
    float part = 1.0 / float(pieces);
    float left = IM_SATURATION, left_in_front = IM_SATURATION;
    for (int k = 0; k < pieces; ++k) {
        vec2 x, y, z, rest, factor;
        float a = mix(low, high, float(k) * part), b = mix(low, high, float(k + 1) * part);
        if (!box_of(way, a, b, x, y, z)) continue;
        rest_and_factor_interval(x, y, z, rest, factor);
        float least = im_abs(rest).x, most = im_abs(factor).y;
        left = most < IM_SATURATION ? min(left, LEFT_OUT * least / max(most, 1.0e-30)) : 0.0;
        if (k < front_pieces) left_in_front = left;
    }
    // Boxes around equal pieces lie evenly between the first and the last. Each element meets them
    // all, and recomputing them would cost more than its bound.
    vec2 first_x, first_y, first_z, last_x, last_y, last_z;
    box_around(way, low, mix(low, high, part), first_x, first_y, first_z);
    box_around(way, mix(low, high, 1.0 - part), high, last_x, last_y, last_z);
    vec2 rounding = vec2(-beam.w, beam.w);
    float per_piece = 1.0 / max(float(pieces - 1), 1.0);
    NewList kept = new_list(block, 0), kept_in_front = new_list(block, 1);
    for (int e = 0; e < array0_count; ++e) {
        float largest = 0.0, in_front = 0.0;
        for (int k = 0; k < pieces; ++k) {
            float along = float(k) * per_piece;
            vec2 x = mix(first_x, last_x, along) + rounding;
            vec2 y = mix(first_y, last_y, along) + rounding;
            vec2 z = mix(first_z, last_z, along) + rounding;
            largest = max(largest, im_abs(term_interval(e, x, y, z)).y);
            if (k < front_pieces) in_front = largest;
            // The element stays.
            if (k + 1 >= front_pieces && !(largest <= 0.125 * left)) break;
        }
        if (largest <= 0.125 * left) {
            left -= largest;
        } else {
            keep(kept, e);
        }
        if (LISTS_OF_A_BLOCK == 1) continue;
        if (in_front <= 0.125 * left_in_front) {
            left_in_front -= in_front;
        } else {
            keep(kept_in_front, e);
        }
    }
    KEPT all = list_of(kept);
    float front_end = mix(low, high, float(front_pieces) * part);
    if (LISTS_OF_A_BLOCK == 1) return Lists(all, all, high);
    return Lists(all, list_of(kept_in_front), front_end);
}

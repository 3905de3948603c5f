// The elements of the array that matter in a beam. F is factor * sum + rest, so at a root the sum
// is as large as rest / factor. Elements are left out whose terms, bounded in pieces of the beam
// and all together, stay below LEFT_OUT of that: float32 loses as much when it adds up some ten
// terms.

vec2 list_of(ivec2 block, Beam way, float low, float high) {
    int first = list.x + (block.y * list.z + block.x) * list.y;
    // Loops must end before drivers end them, silently.
    int pieces = clamp(MOST_TERMS / max(array0_count, 1), 1, PIECES);
    float left = IM_SATURATION;
    for (int k = 0; k < pieces; ++k) {
        vec2 x, y, z, rest, factor;
        float a = mix(low, high, float(k) / float(pieces));
        float b = mix(low, high, float(k + 1) / float(pieces));
        if (!box_of(way, a, b, x, y, z)) continue;
        rest_and_factor_interval(x, y, z, rest, factor);
        float least = im_abs(rest).x, most = im_abs(factor).y;
        left = most < IM_SATURATION ? min(left, LEFT_OUT * least / max(most, 1.0e-30)) : 0.0;
    }
    int kept = 0;
    for (int e = 0; e < array0_count; ++e) {
        float largest = 0.0;
        for (int k = 0; k < pieces; ++k) {
            vec2 x, y, z;
            float a = mix(low, high, float(k) / float(pieces));
            float b = mix(low, high, float(k + 1) / float(pieces));
            if (box_of(way, a, b, x, y, z)) {
                largest = max(largest, im_abs(term_interval(e, x, y, z)).y);
            }
            if (!(largest <= 0.125 * left)) break; // it stays
        }
        if (largest <= 0.125 * left) {
            left -= largest;
            continue;
        }
        if (kept < list.y) {
            for (int t = 0; t < TEXELS; ++t) {
                array0[(first + kept) * TEXELS + t] = array0_texel(e, t);
            }
        }
        kept += 1;
    }
    // What does not fit goes on with the list it came from.
    return kept <= list.y ? vec2(float(kept), float(first))
                          : vec2(float(array0_count), float(array0_first));
}

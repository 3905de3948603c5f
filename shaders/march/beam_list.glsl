// The elements of the array that matter in a beam: what an element's terms add to the sums is bounded
// in pieces of the beam. Elements are left out whose terms, all together, stay below 2^-20 of the
// sums, as large as these are where the beam may first meet the surface: float32 loses as much
// when it adds up some ten terms.

vec2 list_of(Beam way, float low, float high, Scale scale) {
    int first = list.x + (int(pixel_centre.y) * list.z + int(pixel_centre.x)) * list.y;
    float left = 9.53674316e-7;
    int kept = 0;
    // Loops must end before drivers end them, silently.
    int pieces = clamp(20000 / max(array0_count, 1), 1, PIECES);
    for (int e = 0; e < array0_count; ++e) {
        float largest = 0.0;
        for (int k = 0; k < pieces; ++k) {
            vec2 x, y, z;
            float a = mix(low, high, float(k) / float(pieces));
            float b = mix(low, high, float(k + 1) / float(pieces));
            if (box_of(way, a, b, x, y, z)) largest = max(largest, part_of_sums(e, x, y, z, scale));
        }
        if (largest <= 0.125 * left) {
            left -= largest;
            continue;
        }
        if (kept < list.y) {
            for (int t = 0; t < TEXELS; ++t) {
                list_texels[(first + kept) * TEXELS + t] = array0_texel(e, t);
            }
        }
        kept += 1;
    }
    // What does not fit goes on with the list it came from.
    return kept <= list.y ? vec2(float(kept), float(first))
                          : vec2(float(array0_count), float(array0_first));
}

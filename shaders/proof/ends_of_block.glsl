// Finds where the rays of a block end, and what larger blocks proved of it.

// The ends of the rays, in tau.
struct Ends {
    int hits, misses;
    vec2 lean;         // of the plane through the hits
    float first, last; // of hits, above the plane
    float nearest_eye, farthest_eye;
#ifndef COARSE
    float taus[RAYS];
#endif
};

vec2 place_in_block(int k) {
    return vec2(k % BLOCK, k / BLOCK) * (2.0 / float(BLOCK - 1)) - 1.0;
}

#ifdef COARSE
Ends ends_of(ivec2 block) {
    vec3 forward = normalize(cross(normalize(ray_right.xyz), normalize(ray_up.xyz)));
    float nearest_eye = abs(dot(ray_axis.xyz, forward));
    return Ends(0, RAYS, vec2(0.0), 0.0, 0.0, 0.999 * nearest_eye, 0.0);
}

float settled_before(ivec2 block, float low) {
    return low;
}
#else
#ifdef COARSE_BLOCK
uniform sampler2D coarse_block_texture;

float settled_before(ivec2 block, float low) {
    float coarse = IM_TEXEL(coarse_block_texture, block * BLOCK / COARSE_BLOCK).x;
    return coarse > low ? coarse : low; // also for NaN
}
#else
float settled_before(ivec2 block, float low) {
    return low;
}
#endif

Ends ends_of(ivec2 block) {
    Ends ends;
    ends.hits = ends.misses = 0;
    ends.lean = vec2(0.0);
    ends.first = ends.nearest_eye = IM_SATURATION;
    ends.last = -IM_SATURATION;
    ends.farthest_eye = 0.0;
    float squares = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        ivec2 pixel = block * BLOCK + ivec2(k % BLOCK, k / BLOCK);
        Ending ended = load_ending(pixel);
        vec2 at = (vec2(pixel) + 0.5 + picture.zw) * picture.xy - 1.0;
        vec3 across = at.x * ray_right.xyz + at.y * ray_up.xyz;
        float to_eye = length(ray_axis.xyz + ray_axis.w * across);
        vec2 place = place_in_block(k);
        ends.taus[k] = ended.t / to_eye;
        ends.hits += int(ended.hit);
        ends.misses += int(ended.miss);
        ends.lean += ends.taus[k] * place;
        squares += place.x * place.x;
        ends.nearest_eye = min(ends.nearest_eye, to_eye);
        ends.farthest_eye = max(ends.farthest_eye, to_eye);
    }
    ends.lean = ends.hits == RAYS ? ends.lean / squares : vec2(0.0);
    if (ends.hits < RAYS) return ends;
    for (int k = 0; k < RAYS; ++k) {
        float above = ends.taus[k] - dot(ends.lean, place_in_block(k));
        ends.first = min(ends.first, above);
        ends.last = max(ends.last, above);
    }
    return ends;
}
#endif

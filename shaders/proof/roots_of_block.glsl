// The ends of a block's rays, and the proof of their roots.

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

#ifndef COARSE
// Proves the roots of all rays of a block, where all of them hit, by the model of the piece that
// holds these: Newton's step from where each was found stays close to it, see prove.glsl.

// How far F can be from 0 at the rays' ends.
float uncertain_at_ends(Ends ends, Piece piece, Model f) {
    float most = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        vec2 at = place_in_block(k);
        float s = (ends.taus[k] - dot(piece.lean, at) - piece.middle) / piece.half_length;
        float value = f.c + dot(f.l, vec3(at, s)) + dot(f.d, vec3(at * at, s * s)) +
                      dot(f.o, vec3(at.x * at.y, s * at));
        most = max(most, abs(value));
    }
    return md_up(most + f.error + 64.0 * IM_ROUNDING * md_size(f));
}

// `slope`: the least of F in tau over the piece, whose ends keep a distance of 2 tube.w and
// `margin` from all roots.
bool proves_roots(Beam boxes, Ends ends, Piece piece, Model f, float slope, float margin) {
    float leans = abs(piece.lean.x) + abs(piece.lean.y), reaches = piece.half_length + leans;
    // How far a tau may be off: its length, its quotient and the place of its s, 60 ulps at most.
    float rounding = 4.0e-6 * (abs(piece.middle) + reaches);
    float off = uncertain_at_ends(ends, piece, f) / slope * 1.000002 + rounding;
    vec2 x, y, z;
    box_around(boxes, piece.middle - reaches, piece.middle + reaches, x, y, z);
    return slope > 0.0 && off * ends.farthest_eye * 1.000002 <= tube.w &&
           ends.first - leans - off > margin - 1.0 && holds_within_bounds(x, y, z);
}

#ifdef PARENT_SETTLES
// Whether the roots of a block's rays, where all hit, are known to be the first ones: each lies in the slab
// that holds the first root of its ray, and no other one. Roots may be off by `around`, in tau.
bool are_first_roots(ivec2 block, Ends ends, float around) {
    ivec2 larger = block * BLOCK / PARENT_BLOCK, corner = block * BLOCK - larger * PARENT_BLOCK;
    vec4 slab = slab_of(larger, PARENT_SQUARE_BITS);
    float farthest = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        vec2 pixel = vec2(corner + ivec2(k % BLOCK, k / BLOCK));
        farthest = max(farthest, abs(ends.taus[k] - middle_of_slab(slab, pixel, PARENT_BLOCK)));
    }
    return farthest < slab.w - around;
}
#endif
#endif

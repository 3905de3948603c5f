// Proves a block of BLOCK x BLOCK rays of a polynomial F at once, as far as that goes, by models of
// F over pieces of their beam: as block.frag, but for three things. Pieces lie between planes, the
// last of which leans as the surface does that the rays hit, so that a thin piece holds all roots.
// That piece comes first. Of another one the beginning is settled as far as its quadratic keeps off
// 0, less the error of the model.
//
// Larger blocks come before (COARSE), of which only what is before all roots is told.

layout(location = 0) out vec4 block_proof; // as of block.frag

uniform int block_pieces; // at most

// The rays through the middles of a block's pixels, in the plane of the anchors.
struct Across {
    vec3 middle, right, up; // from the middle to the outer pixels
};

Across across_block(ivec2 block) {
    vec2 half_size = 0.5 * float(BLOCK - 1) * picture.xy;
    vec2 at = (vec2(block * BLOCK) + picture.zw + 0.5) * picture.xy - 1.0 + half_size;
    return Across(at.x * ray_right.xyz + at.y * ray_up.xyz, half_size.x * ray_right.xyz,
                  half_size.y * ray_up.xyz);
}

// tau in a piece: middle + s piece + u (lean.x + s turn.x) + v (lean.y + s turn.y)
struct Piece {
    float middle, half_length;
    vec2 lean, turn;
};

Model coordinate_of(Piece piece, float origin, float axis, float across, float right, float up) {
    precise float c = origin + piece.middle * axis;
    precise vec3 l = axis * vec3(piece.lean, piece.half_length);
    precise vec2 turn = axis * piece.turn;
    // What is by the way's beginning, and what widens with it.
    precise float widens = 1.0 + ray_axis.w * piece.middle;
    precise vec3 widening = ray_axis.w * vec3(piece.lean, piece.half_length);
    precise vec2 widening_turn = ray_axis.w * piece.turn;
    precise float middle = c + widens * across;
    precise vec3 linear = l + widening * across + widens * vec3(right, up, 0.0);
    precise vec3 squares = vec3(widening.xy * vec2(right, up), 0.0);
    precise vec3 others = vec3(widening.x * up + widening.y * right,
                               turn + widening_turn * across + widening.z * vec2(right, up));
    float cubic = md_sum(vec3(widening_turn, 0.0)) * (abs(right) + abs(up));
    // beam.w has the rounding of all this, but for the terms that lean.
    float off = beam.w + cubic + 8.0 * IM_ROUNDING * (abs(middle) + md_sum(linear) + md_sum(others));
    // Rays are straight: what they are off by is linear in s.
    return md_model(middle, linear, squares, others, md_up(off), md_up(off));
}

Model model_of_piece(Across way, Piece piece) {
    vec3 o = ray_origin.xyz, a = ray_axis.xyz, m = way.middle, r = way.right, u = way.up;
    return field_model(coordinate_of(piece, o.x, a.x, m.x, r.x, u.x),
                       coordinate_of(piece, o.y, a.y, m.y, r.y, u.y),
                       coordinate_of(piece, o.z, a.z, m.z, r.z, u.z));
}

// Where in tau the rays end.
struct Ends {
    int hits, misses;
    vec2 lean;         // of the plane through the hits
    float first, last; // of hits, above the plane
    float nearest_eye;
};

vec2 place_in_block(int k) {
    return vec2(k % BLOCK, k / BLOCK) * (2.0 / float(BLOCK - 1)) - 1.0;
}

#ifdef COARSE
Ends ends_of(ivec2 block) {
    float nearest_eye = abs(dot(ray_axis.xyz, normalize(cross(ray_right.xyz, ray_up.xyz))));
    return Ends(0, RAYS, vec2(0.0), 0.0, 0.0, 0.999 * nearest_eye);
}

float settled_before(ivec2 block, float low) {
    return low;
}
#else
uniform sampler2D coarse_block_texture;

float settled_before(ivec2 block, float low) {
    return max(texelFetch(coarse_block_texture, block * BLOCK / COARSE_BLOCK, 0).x, low);
}

Ends ends_of(ivec2 block) {
    Ends ends = Ends(0, 0, vec2(0.0), IM_SATURATION, -IM_SATURATION, IM_SATURATION);
    float taus[RAYS];
    float squares = 0.0;
    for (int k = 0; k < RAYS; ++k) {
        ivec2 pixel = block * BLOCK + ivec2(k % BLOCK, k / BLOCK);
        Ending ended = load_ending(pixel);
        vec2 at = (vec2(pixel) + 0.5 + picture.zw) * picture.xy - 1.0;
        vec3 across = at.x * ray_right.xyz + at.y * ray_up.xyz;
        float to_eye = length(ray_axis.xyz + ray_axis.w * across);
        vec2 place = place_in_block(k);
        taus[k] = ended.t / to_eye;
        ends.hits += int(ended.hit);
        ends.misses += int(ended.miss);
        ends.lean += taus[k] * place;
        squares += place.x * place.x;
        ends.nearest_eye = min(ends.nearest_eye, to_eye);
    }
    ends.lean = ends.hits == RAYS ? ends.lean / squares : vec2(0.0);
    if (ends.hits < RAYS) return ends;
    for (int k = 0; k < RAYS; ++k) {
        float above = taus[k] - dot(ends.lean, place_in_block(k));
        ends.first = min(ends.first, above);
        ends.last = max(ends.last, above);
    }
    return ends;
}
#endif

void main() {
    ivec2 block = ivec2(pixel_centre);
    Beam boxes = beam_of(block);
    Across way = across_block(block);
    Part whole = parent_part(block);
    Ends ends = ends_of(block);
    bool all_hit = ends.hits == RAYS, all_miss = ends.misses == RAYS;
    float margin = 2.0 * tube.z / ends.nearest_eye;
    float around = 2.0 * tube.w / ends.nearest_eye + margin;
    float low = settled_before(block, whole.low - margin), high = whole.high + margin;
    bool open = low < high && ends.hits + ends.misses > 0, roots = open && all_hit;
    // The piece with the roots, above the leaning plane.
    // Roots are to be as far from its ends as begin.frag takes for granted.
    float beside = around + 0.3 * beam.z + 0.05 * (ends.last - ends.first);
    float last = all_hit ? ends.last + beside : high, leans = abs(ends.lean.x) + abs(ends.lean.y);
    // What is before, from low to here, in parts of it for each ray.
    float first = all_hit ? ends.first - beside : high;
    if (all_hit) low = min(low, first - leans - around);

    float way_length = first - low;
    float settled = 0.0, part = 1.0, slope = 0.0;
    for (int k = 0; k < block_pieces && open; ++k) {
        float to = min(settled + part, 1.0);
        float middle = 0.5 * (settled + to), half_part = 0.500001 * (to - settled) + IM_DRIVER_ERROR;
        float off = IM_DRIVER_ERROR * (abs(low) + abs(first)); // of its ends
        Piece piece = Piece(low + middle * way_length, half_part * way_length + off,
                            middle * ends.lean, half_part * ends.lean);
        if (roots)
            piece = Piece(0.5 * (first + last), 0.500001 * (last - first) + off, ends.lean, vec2(0.0));
        Model f = model_of_piece(way, piece);
        float size = md_size(f), rounding = 8.0 * IM_ROUNDING * size;
        // The beginning, in y.
        bool below = f.c - f.l.z + f.d.z < 0.0;
        float upright = below ? -1.0 : 1.0;
        float c = upright * f.c, l = upright * f.l.z, d = upright * f.d.z;
        vec2 bend = min(upright * f.d.xy, 0.0);
        float aside = abs(f.l.x) + abs(f.l.y) + md_sum(f.o) - bend.x - bend.y + f.error;
        precise float g0 = c - l + d - 1.000001 * aside;
        precise float g1 = l - 2.0 * d;
        float reach = first_reach(g0, g1, d, 64.0 * IM_ROUNDING * size);
        if (roots) {
            float bends = 2.0 * abs(f.d.z) + abs(f.o.y) + abs(f.o.z);
            precise float least = abs(f.l.z) - 1.000001 * (bends + f.slope_error) - rounding;
            slope = least > 0.0 ? 0.999999 * least / piece.half_length : 0.0;
            roots = false;
        } else {
            vec2 x, y, z;
            float reaches = piece.half_length + leans * (middle + half_part);
            box_around(boxes, piece.middle - reaches, piece.middle + reaches, x, y, z);
            bool is_free = reach >= 2.0 || !meets_bounds(x, y, z);
            float done = is_free ? 1.0 : reach > 0.05 ? 0.499 * reach : 0.0;
            part = (is_free ? 2.0 : done > 0.0 ? max(done, 0.2) : 0.3) * (to - settled);
            settled = is_free ? to : max(settled + done * (to - settled) - IM_DRIVER_ERROR, 0.0);
        }
        open = settled < 1.0 && part * way_length > 0.25 * beam.z;
    }
    bool settles = settled >= 1.0 || !(low < high);
    slope = all_miss && settles ? -1.0 : settles ? slope : 0.0;
    float settled_to = low + settled * way_length - margin;
#ifdef COARSE
    if (settles) settled_to = IM_SATURATION;
#endif
    block_proof = vec4(settled_to, settled * ends.lean, slope);
}

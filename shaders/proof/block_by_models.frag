// Proves a block of BLOCK x BLOCK rays of a polynomial F at once, as far as possible, by models of
// F over pieces of their beam. It differs from block.frag in three ways. Pieces lie between planes,
// and the last plane leans as the surface does at the hits, so that a thin piece holds all roots.
// That piece comes first, and may prove the roots themselves: roots_of_block.glsl. In any other
// piece the beginning is settled as far as the quadratic stays away from 0, less the model's error.
//
// Larger blocks come before (COARSE); they only prove the part before all roots.

layout(location = 0) out vec4 block_proof; // as in block.frag

uniform int block_pieces; // limit on the pieces

void main() {
    ivec2 block = ivec2(pixel_centre);
    Beam boxes = beam_of(block);
    Across way = across_block(block);
    Part whole = parent_part(block);
    bool has_way = whole.low < whole.high; // else larger beams proved that no ray hits
    Ends ends = ends_of(block);
    bool all_hit = ends.hits == RAYS, all_miss = ends.misses == RAYS;
    float margin = 2.0 * tube.z / ends.nearest_eye;
    float around = 2.0 * tube.w / ends.nearest_eye + margin;
    float low = settled_before(block, whole.low - margin), high = whole.high + margin;
    bool open = has_way && low < high && ends.hits + ends.misses > 0, roots = open && all_hit;
    // The piece with the roots, above the leaning plane. Roots must keep the distance from its ends
    // that begin.frag assumes.
    float beside = around + 0.3 * beam.z + 0.05 * (ends.last - ends.first);
    float last = all_hit ? ends.last + beside : high, leans = abs(ends.lean.x) + abs(ends.lean.y);
    // The part before, from low to here, between planes that lean in proportion.
    float first = all_hit ? ends.first - beside : high;
    if (all_hit) low = min(low, first - leans - around);
    // beam.w hardly holds beyond the bounds.
    open = open && low > beam.x - 0.5 * (beam.y - beam.x);

    float way_length = first - low;
    float settled = 0.0, part = 1.0, slope = 0.0;
    bool roots_proved = false;
    int pieces = 0;
    do { // as in prove_by_models.glsl
        if (!open) break;
        float to = min(settled + part, 1.0);
        float middle = 0.5 * (settled + to), half_part = 0.500001 * (to - settled) + IM_DRIVER_ERROR;
        float off = IM_DRIVER_ERROR * (abs(low) + abs(first)); // error of its ends
        Piece piece = Piece(low + middle * way_length, half_part * way_length + off,
                            middle * ends.lean, half_part * ends.lean);
        if (roots)
            piece = Piece(0.5 * (first + last), 0.500001 * (last - first) + off, ends.lean, vec2(0.0));
        Model f = model_of_piece(way, piece);
        float size = md_size(f), rounding = 8.0 * IM_ROUNDING * size;
        // The beginning of the piece, as a polynomial in y.
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
#ifndef COARSE
            roots_proved = proves_roots(boxes, ends, piece, f, slope, margin);
#ifdef PARENT_SETTLES
            if (roots_proved && are_first_roots(block, ends, around)) settled = 1.0;
#endif
#endif
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
        ++pieces;
    } while (open && pieces < block_pieces);
    bool settles = settled >= 1.0 || low >= high || all_miss && !has_way;
    if (!settles) slope = 0.0;
    if (settles && all_miss) slope = BLOCK_MISSES;
    if (roots_proved && settled >= 1.0) slope = BLOCK_HITS;
    float settled_to = low + settled * way_length - margin;
#ifdef COARSE
    if (settles) settled_to = IM_SATURATION;
#endif
    block_proof = vec4(settled_to, settled * ends.lean, slope);
}

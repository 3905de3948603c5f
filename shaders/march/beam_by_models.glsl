// Finds which part of their way holds the roots of a block's rays, as beam_by_intervals.glsl does, by models of F
// over pieces of the block's beam: models/block.glsl. It settles blocks whose rays all hit one smooth sheet:
// it proves of a piece of the beam that it holds the first root of each of them.
//
// The walk goes from the near end on, and passes pieces as far as F certainly keeps its sign there. A
// piece in which F is monotone along all rays, and falls towards 0, proposes where the roots are: on the plane
// on which its model is 0 up to the model's other terms. A slab about this plane is the next piece. If F is
// monotone in the slab, too, and changes its sign from one face to the other for all rays, each
// has one root there. None comes before: F keeps its sign up to `low`, within the bounds, and from there to the slab it
// is monotone in the direction in which it goes through 0 in the slab.

// `part` is of tau, empty without roots; its .z is 1 if the block is settled. Rays of a block that is not settled march all
// that intervals left: rays that begin elsewhere take other samples, and find other roots where F touches 0. Proofs
// know that there are no roots before roots.x and behind part.w. For these (BOTH_ENDS) the walk ends with pieces
// from the far end.
//
// `roots` is the slab of a settled block, in tau: its middle in the block's middle, how far it leans to
// the outer pixels, half its thickness.

uniform int beam_evaluations;

// How far F may be from the linear part of its model.
float beside_linear(Model f) {
    return f.square + f.error + 8.0 * IM_ROUNDING * md_size(f);
}

// The least slope of F in s towards 0, if it has one sign in the piece; otherwise below 0.
float least_slope(Model f) {
    float turn = 1.000001 * (md_turn(f) + f.slope_error) + 8.0 * IM_ROUNDING * md_size(f);
    return abs(f.l.z) - turn;
}

// Whether F changes its sign once along each ray, from face to face.
bool holds_roots(Model f) {
    precise float at_faces = abs(f.l.z) - 1.000001 * (abs(f.c) + abs(f.l.x) + abs(f.l.y) + beside_linear(f));
    return at_faces > 0.0 && least_slope(f) > 0.0;
}

// The slab about the plane on which the linear part of a piece's model is 0.
Piece slab_in(Piece piece, Model f) {
    float per_slope = 1.0 / f.l.z;
    vec2 lean = -per_slope * f.l.xy;
    // Beside what F may be off, some room for roots that are known nearly: proof/roots_of_block.glsl.
    float thick = 1.1 * abs(per_slope) * beside_linear(f) * piece.half_length + 0.03 * beam.z;
    return Piece(piece.middle - per_slope * f.c * piece.half_length, thick,
                 lean * piece.half_length, vec2(0.0));
}

void follow_beam(ivec2 block) {
    Beam boxes = beam_of(block);
    Across way = across_block(block);
    Part whole = parent_part(block);
    float low = whole.low, high = whole.high, piece_length = 2.0 * whole.first;
    Piece slab = Piece(0.0, 0.0, vec2(0.0), vec2(0.0));
    bool is_slab = false, was_slab = false, is_settled = false, backwards = false, open = low < high;
    int longer = 0, k = 0;
    do { // as in prove.glsl
        if (!open) break;
        float begin = backwards ? max(high - piece_length, low) : low;
        float end = backwards ? high : min(low + piece_length, high);
        float off = IM_DRIVER_ERROR * (abs(begin) + abs(end)); // error of the piece's ends
        Piece piece = slab;
        if (!is_slab)
            piece = Piece(0.5 * (begin + end), 0.500001 * (end - begin) + off, vec2(0.0), vec2(0.0));
        Model f = model_of_piece(way, piece);
        vec2 x, y, z;
        float reaches = piece.half_length + abs(piece.lean.x) + abs(piece.lean.y);
        box_around(boxes, piece.middle - reaches, piece.middle + reaches, x, y, z);
        // The beginning of the piece, as in proof/block_by_models.frag.
        float upright = f.c - f.l.z + f.d.z < 0.0 ? -1.0 : 1.0;
        float c = upright * f.c, l = upright * f.l.z, d = upright * f.d.z;
        vec2 bend = min(upright * f.d.xy, 0.0);
        float aside = abs(f.l.x) + abs(f.l.y) + md_sum(f.o) - bend.x - bend.y + f.error;
        float rounding = 64.0 * IM_ROUNDING * md_size(f);
        precise float g0 = c - l + d - 1.000001 * aside;
        precise float g1 = l - 2.0 * d;
        if (is_slab) {
            // Whole in the bounds, so that no ray begins or ends in it.
            is_settled = holds_roots(f) && holds_within_bounds(x, y, z) && piece.middle - reaches > beam.x;
            open = !is_settled;
            is_slab = false;
            was_slab = true;
        } else {
            float reach = first_reach(g0, g1, d, rounding);
            bool is_free = reach >= 2.0 || !meets_bounds(x, y, z);
            // In sixteenths, so that rounding hardly changes how far walks come and which blocks they settle.
            float done = is_free ? 1.0 : floor(7.99 * reach) / 16.0;
            bool falls = !is_free && !was_slab && !backwards && g0 > rounding && l < 0.0 && least_slope(f) > 0.0;
            slab = slab_in(piece, f);
            float leans = abs(slab.lean.x) + abs(slab.lean.y);
            float rounded = 4.0 * IM_DRIVER_ERROR * (abs(slab.middle) + leans + slab.half_length);
            is_slab = falls && slab.middle + leans - slab.half_length < end - 4.0 * off - rounded;
            if (!is_slab) {
                float way_length = end - begin;
                bool lengthens = is_free || falls && longer < 3;
                longer += int(falls);
                piece_length = (lengthens ? 2.0 : done > 0.0 && !backwards ? max(done, 0.2) : 0.3) * way_length;
                if (backwards && is_free) high = begin;
                if (!backwards) low = is_free ? end : max(low + done * way_length - off, low);
                was_slab = false;
            }
            open = is_slab || low < high && piece_length > 0.5 * beam.z;
#if BOTH_ENDS
            bool turns = !open && low < high && !backwards;
            if (turns) piece_length = 0.25 * (high - low);
            backwards = backwards || turns;
            open = open || turns;
#endif
        }
        ++k;
    } while (open && k < beam_evaluations);
    part = vec4(low < whole.high ? whole.low : low, whole.high, 0.0, high);
    roots = vec4(low, 0.0, 0.0, 0.0);
    // Shadow rays end on the surface: a slab leaves them too little way to tell a root from their end.
    bool is_of_light = around_middles > 0.0;
    if (is_settled && !is_of_light) {
        float reaches = slab.half_length + abs(slab.lean.x) + abs(slab.lean.y);
        float top = slab.middle + reaches;
        part = vec4(slab.middle - reaches, top, 1.0, top);
        roots = vec4(slab.middle, slab.lean, slab.half_length);
    }
}

// Proves where a ray of a polynomial F ended, by models of F over pieces of all rays that float32
// may make of it. It follows prove.glsl, but a piece's quadratic is tighter than bounds.
//
// First the root, in the middle of a piece: if the model's slope excludes 0, the range of F at the
// root over the least slope encloses the one root of each ray (Newton's step, Moore 1966). Then the
// part before, backwards from there: F stays away from 0 as far as the quadratic does, less the
// model's error.

uniform int pieces_per_pass;
uniform int most_pieces;

ProofState conclude(ProofState s, int outcome) {
    s.outcome = outcome;
    return s;
}

// Continues where a proof was given up.
ProofState resume_proof(ProofState s) {
    s.piece = max(s.at_root ? 32.0 * tube.w : 4.0 * s.piece, shortest_piece);
    s.outcome = PROOF_UNFINISHED;
    s.pieces = 0;
    return s;
}

// The part of a root's piece, to both sides, that its proof settles; the rest is for rounding.
const float PART_OF_ROOT = 0.98;

// The pieces that a root may take in floats.
const int MOST_AT_ROOT = 4;

// `uncertain`: how large F can be at the root.
ProofState prove_root(ProofState s, ProofRay ray, bool hit, REAL uncertain) {
    REAL high = s.settled;
    // A root's piece should hardly extend beyond the ray, where tube.x holds.
    REAL beyond = max(ray.t_far, -ray.t_near) - high;
    // The first one is some pixels long: it tells how long others may be.
    float longest = s.pieces == 0 ? max(24.0 * tube.w, shortest_piece) : s.piece;
    float piece = float(min(min(s.piece, longest), max(beyond, tube.w)));
    REAL low = float(max(s.settled - piece, ray.t_near));
    REAL half_piece = REAL(piece / PART_OF_ROOT);
    Model f = model_of_piece(ray, high, half_piece);
    s.pieces += 1;
    REAL size = md_size(f), rounding = 8.0 * IM_ROUNDING * size;

    // The factors exceed float32's error in these lines by half a millionth. The directions of the
    // rays differ, in s, by at most `apart` times what the points do.
    REAL apart = min(half_piece * tube.y / tube.x * 1.00001, 1.0);
    REAL bends = 2.0 * abs(f.c.z);
    REAL rest = md_slope_off(f, apart);
    precise REAL steepness = abs(f.c.y) - 1.000001 * (bends + rest) - rounding;
    precise REAL off = uncertain / steepness * half_piece * 1.000002 + 4.76837158e-7 * abs(high);
    bool isolates = steepness > 0.0 && off <= tube.w && off <= PART_OF_ROOT * half_piece &&
                    high - off > 2.0 * tube.z - ray.to_eye &&
                    inside_bounds(vec3(ray_point(ray, high - off))) &&
                    inside_bounds(vec3(ray_point(ray, high + off)));
    // No shorter piece could bring the root close enough; or the rounding of floats hides the slope,
    // since shorter ones did not tell it either.
    bool hopeless = uncertain * half_piece > 1.2 * tube.w * (abs(f.c.y) + bends + rest) ||
                    !SAMPLES_ROOTS && s.pieces >= MOST_AT_ROOT;
    REAL by_bend = 0.5 * abs(f.c.y) / bends, by_rest = 0.5 * sqrt(abs(f.c.y) / rest);
    REAL shorter = min(by_bend, by_rest);

    if (isolates) {
        s.settled = float(low);
        s.piece = float(max(4.0 * (high - low), shortest_piece));
        s.value = 0.0;
        s.at_root = false;
        if (s.settled <= ray.t_near) s = conclude(s, hit ? PROOF_HIT : PROOF_MISS);
    } else {
        s.piece = float((shorter > 0.1 ? min(shorter, 0.7) : REAL(0.1)) * REAL(piece));
        bool bounded = size + md_off(f) < IM_SATURATION;
        if (hopeless || !(s.piece >= shortest_piece))
            s = conclude(s, bounded ? PROOF_SIGN : PROOF_UNBOUNDED);
    }
    if (s.outcome == PROOF_UNFINISHED && s.pieces >= most_pieces) s = conclude(s, PROOF_BUDGET);
    return s;
}

// How many times as long a piece may be before what its model leaves out, which grows with the third
// power of the length, reaches `value`.
float longer(REAL value, REAL error) {
    return pow(clamp(float(value / error), 1.0e-3, 1.0e3), 1.0 / 3.0);
}

// How many times as long as a piece where F > 0 the next one may be: at most up to where the
// quadratic is 0.
float onwards(REAL3 c, REAL error) {
    REAL value = c.x - c.y + c.z, slope = 2.0 * c.z - c.y; // at the piece's beginning, backwards
    REAL below = sqrt(max(slope * slope - 4.0 * value * c.z, 0.0)) - slope;
    float to_root = below > 0.0 && slope * slope >= 4.0 * value * c.z ? float(value / below) : 10.0;
    return clamp(min(0.75 * longer(value, error), 1.6 * to_root), 1.0, 5.0);
}

// A piece of the part before the root.
ProofState prove_before(ProofState s, ProofRay ray, bool hit) {
    REAL high = s.settled;
    REAL low = float(max(s.settled - s.piece, ray.t_near));
    REAL middle = 0.5 * (low + high);
    // Slightly longer than its ends need.
    Model f = model_of_piece(ray, middle,
                             0.500001 * (high - low) + IM_DRIVER_ERROR * abs(middle));
    s.pieces += 1;
    REAL error = md_off(f), size = md_size(f);

    // With signs flipped so that F > 0 at its end; y runs backwards from there.
    bool below = f.c.x + f.c.y + f.c.z < 0.0;
    REAL3 c = below ? -f.c : f.c;
    precise REAL g0 = c.x + c.y + c.z - error;
    precise REAL g1 = -c.y - 2.0 * c.z;
    REAL reach = first_reach(g0, g1, c.z, 64.0 * IM_ROUNDING * size);
    bool is_free = reach >= 2.0;

    bool succeeds = reach > 0.05;
    if (succeeds) {
        // Settles a part of the piece, less the rounding of its ends, to a float no lower.
        REAL part_done = high - 0.499 * reach * (high - low) + IM_DRIVER_ERROR * abs(middle);
        s.settled = is_free ? float(low) : float(part_done + 4.76837158e-7 * abs(part_done));
        REAL length = high - s.settled;
        // What a model leaves out falls with the third power of its length, so that one which
        // settled only its beginning was hardly too long.
        REAL next = is_free ? onwards(c, error) * length : max(length, 0.6 * (high - low));
        s.piece = float(max(next, shortest_piece));
        if (s.settled <= ray.t_near) s = conclude(s, hit ? PROOF_HIT : PROOF_MISS);
        // Otherwise the proof hardly advanced.
        succeeds = is_free || length >= 0.25 * shortest_piece;
    }
    if (!succeeds && s.outcome == PROOF_UNFINISHED) {
        float length = float(high - low);
        float part = error < IM_SATURATION ? clamp(0.8 * longer(c.x + c.y + c.z, error), 0.1, 0.6) : 0.4;
        // The shortest one is tried before a proof is given up.
        s.piece = max(part * length, min(0.4 * length, shortest_piece));
        bool bounded = size + error < IM_SATURATION;
        if (!(s.piece >= shortest_piece)) s = conclude(s, bounded ? PROOF_HIDDEN : PROOF_UNBOUNDED);
    }
    if (s.outcome == PROOF_UNFINISHED && s.pieces >= most_pieces) s = conclude(s, PROOF_BUDGET);
    return s;
}

// Continues a proof by the pieces of a pass. Software renderers go through neighbouring rays in
// step, and once more through a loop whose condition comes first.
ProofState prove_pieces(ProofState s, ProofRay ray, bool hit) {
    REAL uncertain = uncertain_at_root(s, value_at(ray, s.settled));
    int turns = pieces_per_pass;
    do {
        if (s.outcome != PROOF_UNFINISHED || !s.at_root) break;
        s = prove_root(s, ray, hit, uncertain);
        --turns;
    } while (turns > 0 && s.outcome == PROOF_UNFINISHED && s.at_root);
    do {
        if (turns <= 0 || s.outcome != PROOF_UNFINISHED) break;
        s = prove_before(s, ray, hit);
        --turns;
    } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    return s;
}

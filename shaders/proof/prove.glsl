// Proves where a ray ended, by bounds on F and dF/dt over pieces of all rays that float32 may make
// of it.
//
// First the root: over a piece around it in which dF/dt excludes 0, Newton's step with all values
// of F at the root and all slopes (Moore 1966) encloses the one root of each ray, if that step
// stays in the piece. Then the part before, backwards from there: F stays away from 0 in a piece by
// its natural bound, or because its values at both ends, which neighbouring pieces share, are too
// far from 0 for its slope.

uniform int pieces_per_pass;
uniform int most_pieces;

ProofState conclude(ProofState s, int outcome) {
    s.outcome = outcome;
    return s;
}

// Continues where a proof was given up.
ProofState resume_proof(ProofState s) {
    float piece = s.at_root ? 32.0 * tube.w : 4.0 * s.piece;
    s.piece = max(piece, shortest_piece);
#ifdef LISTS
    // A value of F for other elements, see elements/lists.glsl, does not hold for every F here.
    if (!s.at_root) s.value = 0.0;
#endif
    s.outcome = PROOF_UNFINISHED;
    s.pieces = 0;
    return s;
}

// Settles everything from t, a float, on; F there is at least as far from 0 as `value`.
ProofState settle(ProofState s, ProofRay ray, bool hit, REAL t, REAL value) {
    s.settled = float(t);
    s.value = toward_zero(value);
    s.at_root = false;
    return t <= ray.t_near ? conclude(s, hit ? PROOF_HIT : PROOF_MISS) : s;
}

ProofState prove_piece(ProofState s, ProofRay ray, bool hit) {
    REAL low = float(max(s.settled - s.piece, ray.t_near));
    REAL high = s.at_root ? s.settled + min(s.piece, tube.w) : s.settled;
    // Loops over elements end at once where no ray goes through them.
    REAL2 there = REAL2(0.0);
    if (SAMPLES_ROOTS || !s.at_root) there = value_at(ray, sampled_at(s, low));
    REAL uncertain = uncertain_at_root(s, there);
    REAL4 f = bounds_of_piece(ray, low, high);
    s.pieces += 1;

    // The root. The factors exceed float32's error in these lines by half a millionth.
    precise REAL steepness = max(f.z, -f.w); // the least slope, if positive
    precise REAL off = uncertain / steepness * 1.000002 + 4.76837158e-7 * abs(s.settled);
    bool isolates = steepness > 0.0 && off <= high - s.settled && off <= s.settled - low &&
                    s.settled - off > 2.0 * tube.z - ray.to_eye &&
                    inside_bounds(vec3(ray_point(ray, s.settled - off))) &&
                    inside_bounds(vec3(ray_point(ray, s.settled + off)));
    precise REAL ahead = steepness * (0.999998 * (s.settled - low) - off);

    // The part before, with signs flipped so that F > 0 at its beginning.
    bool below = there.y < 0.0;
    REAL near = below ? -there.y : there.x, far = below ? -s.value : s.value;
    REAL fall = max(below ? f.w : -f.z, 0.0), rise = max(below ? -f.z : f.w, 0.0);
    precise REAL h = (high - low) * 1.000002;
    // Two lines below F, one from either end, cross above 0.
    precise REAL cross_at = near * rise + far * fall;
    precise REAL deep = fall * rise * h * 1.000002 + 1.0e-34 * (1.0 + h);
    bool natural = f.x > 0.0 || f.y < 0.0;
    bool is_free = natural || near > 0.0 && (near > fall * h || far > rise * h ||
                                             far > 0.0 && cross_at > deep);
    REAL kept = near > 0.0 ? near : max(f.x, -f.y);

    // Derives the next piece's length from how far this one was from the other outcome. Slopes over
    // a piece spread about as its length, so what keeps F off 0 falls with its square.
    REAL spread = 0.5 * (f.w - f.z), middle = 0.5 * abs(f.z + f.w);
    // For the root: dF/dt must exclude 0 and be steep enough to bring Newton's step close enough.
    REAL by_root = 0.8 * (middle - 1.1 * uncertain / tube.w) / spread;
    REAL by_near = near > 0.0 ? max(cross_at / deep, near / (fall * h)) : REAL(0.0);
    REAL by_value = max(by_near, far / (rise * h));
    // The natural bound spreads about as the length.
    REAL by_range = abs(f.x + f.y) / (f.y - f.x);
    REAL least = s.at_root ? 0.03 : !is_free ? 0.3 : 1.0;
    REAL most = s.at_root || !is_free ? 0.7 : 3.0;
    REAL part = s.at_root ? by_root : max(0.9 * sqrt(by_value), 0.7 * by_range);
    part = part > least ? min(part, most) : least; // also for NaN
    // No shorter piece could bring Newton's step close enough.
    bool hopeless = s.at_root && uncertain > tube.w * max(-f.z, f.w);
    REAL length = s.settled - low;

    bool succeeds = s.at_root ? isolates : is_free;
    if (succeeds) {
        REAL value = s.at_root ? (f.z > 0.0 ? -1.0 : 1.0) * max(ahead, 0.0)
                                : (near > 0.0 ? below : f.y < 0.0) ? -kept : kept;
        // Behind the root F grows as long as its slope keeps its sign.
        REAL onwards = s.at_root ? clamp(by_root, 2.0, 16.0) : part;
        s.piece = float(max(onwards * length, shortest_piece));
        s = settle(s, ray, hit, low, value);
    } else {
        s.piece = float(part * length);
        bool bounded = abs(f.x) < IM_SATURATION && abs(f.y) < IM_SATURATION &&
                       abs(f.z) < IM_SATURATION && abs(f.w) < IM_SATURATION;
        int why = !bounded ? PROOF_UNBOUNDED : s.at_root ? PROOF_SIGN : PROOF_HIDDEN;
        if (hopeless || !(s.piece >= shortest_piece)) s = conclude(s, why);
    }
    if (s.outcome == PROOF_UNFINISHED && s.pieces >= most_pieces) s = conclude(s, PROOF_BUDGET);
    return s;
}

// Continues a proof by the pieces of a pass. Software renderers go through neighbouring rays in step,
// and once more through a loop whose condition comes first.
ProofState prove_pieces(ProofState s, ProofRay ray, bool hit) {
    int turns = pieces_per_pass;
    do {
        if (turns <= 0 || s.outcome != PROOF_UNFINISHED) break;
        s = prove_piece(s, ray, hit);
        turns = HAS_ELEMENTS_LEFT ? turns - 1 : 0;
    } while (turns > 0 && s.outcome == PROOF_UNFINISHED);
    return s;
}

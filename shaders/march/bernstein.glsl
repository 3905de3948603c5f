// Polynomials in Bernstein form on [0, 1]. The number of roots is the number of sign changes of the
// coefficients, or less by an even number.

// Splits the polynomial in `right` into its parts on [0, u] and on [u, 1], by de Casteljau. Returns
// p(u) and p'(u).
vec2 split(inout float right[DEGREE + 1], out float left[DEGREE + 1], float u) {
    float slope = 0.0;
    left[0] = right[0];
    for (int level = 1; level <= DEGREE; ++level) {
        if (level == DEGREE) slope = float(DEGREE) * (right[1] - right[0]);
        for (int i = 0; i <= DEGREE - level; ++i) right[i] += u * (right[i + 1] - right[i]);
        left[level] = right[0];
    }
    return vec2(right[0], slope);
}

// The number of sign changes of the coefficients, and where their polygon first changes its sign.
struct Changes {
    int count;
    float first;
};

Changes sign_changes(float b[DEGREE + 1]) {
    int count = 0;
    float place = 0.0, before = 1.0, after = 0.0;
    for (int i = DEGREE - 1; i >= 0; --i) {
        bool changes = (b[i] > 0.0) != (b[i + 1] > 0.0);
        count += int(changes);
        place = changes ? float(i) : place;
        before = changes ? b[i] : before;
        after = changes ? b[i + 1] : after;
    }
    return Changes(count, (place + before / (before - after)) * (1.0 / float(DEGREE)));
}

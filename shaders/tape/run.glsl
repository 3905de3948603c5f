// Runs a tape from its first instruction on: src/formula/tape/tape_words.h. Registers hold the
// inputs before and the outputs behind.
//
// The text of each tape names what is in capital letters: the functions TAPE_RUN, TAPE_OPERANDS and
// TAPE_STEP, what it applies, TAPE_APPLY, and TAPE_CALL, the calls of a tape of groups; the
// TAPE_REGISTERS, each a TAPE_NUMBER that TAPE_LITERAL reads and TAPE_CHOOSE selects.

void TAPE_OPERANDS(uvec2 word, out TAPE_NUMBER a, out TAPE_NUMBER b) {
    TAPE_NUMBER first = TAPE_REGISTERS[int(word.x >> 21)];
    TAPE_NUMBER second = TAPE_REGISTERS[int(word.y & TAPE_MASK)];
    second = TAPE_CHOOSE((word.x & 128u) != 0u, TAPE_LITERAL(word), second);
    bool exchanged = (word.x & 256u) != 0u;
    a = TAPE_CHOOSE(exchanged, second, first);
    b = TAPE_CHOOSE(exchanged, first, second);
}

void TAPE_STEP(int at, inout TAPE_NUMBER held_a, inout TAPE_NUMBER held_b) {
    uvec2 word = IM_BUFFER_AT(tape_words, at).xy;
    uint op = word.x & 127u;
    TAPE_NUMBER a, b;
    TAPE_OPERANDS(word, a, b);
    TAPE_REGISTERS[int((word.x >> 10) & 2047u)] = TAPE_APPLY(op, a, b, held_a, held_b);
    held_a = TAPE_CHOOSE(op == 1u, a, held_a);
    held_b = TAPE_CHOOSE(op == 1u, b, held_b);
}

void TAPE_RUN(uvec2 span) {
    int at = int(span.x), end = at + int(span.y), stop = end;
    TAPE_NUMBER held_a = TAPE_NUMBER(0.0), held_b = TAPE_NUMBER(0.0);
    // Software renderers run a loop's body once more after a break at its top.
#ifdef CALLS
    do {
        uvec2 word = IM_BUFFER_AT(tape_words, at).xy;
        TAPE_NUMBER a, b;
        TAPE_OPERANDS(word, a, b);
        TAPE_REGISTERS[int((word.x >> 10) & 2047u)] =
            TAPE_CALL(word.x & 127u, a, b, held_a, held_b);
        stop = at + 2 + int(IM_BUFFER_AT(tape_words, at + 1).x);
        at += 2;
#endif
        do {
            TAPE_STEP(at, held_a, held_b);
            TAPE_STEP(at + 1, held_a, held_b);
            TAPE_STEP(at + 2, held_a, held_b);
            TAPE_STEP(at + 3, held_a, held_b);
            TAPE_STEP(at + 4, held_a, held_b);
            TAPE_STEP(at + 5, held_a, held_b);
            TAPE_STEP(at + 6, held_a, held_b);
            TAPE_STEP(at + 7, held_a, held_b);
            at += 8;
        } while (at < stop);
#ifdef CALLS
    } while (at < end);
#endif
}

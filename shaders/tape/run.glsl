// Runs a tape from its first instruction on: src/formula/tape/tape_words.h. Registers hold the
// inputs before and the outputs behind.
//
// TAPE_RUN names the function, TAPE_APPLY what it applies, and TAPE_CALL what the calls of a tape
// of groups are.
#define TAPE_OPERANDS                                                                              \
    TAPE_NUMBER first = TAPE_REGISTERS[int(word.x >> 21)];                                         \
    TAPE_NUMBER second = TAPE_REGISTERS[int(word.y & TAPE_MASK)];                                  \
    second = TAPE_CHOOSE((word.x & 128u) != 0u, tape_literal(word), second);                       \
    bool exchanged = (word.x & 256u) != 0u;                                                        \
    TAPE_NUMBER a = TAPE_CHOOSE(exchanged, second, first);                                         \
    TAPE_NUMBER b = TAPE_CHOOSE(exchanged, first, second);
#define TAPE_STEP                                                                                  \
    {                                                                                              \
        uvec2 word = IM_BUFFER_AT(tape_words, at).xy;                                              \
        uint op = word.x & 127u;                                                                   \
        TAPE_OPERANDS                                                                              \
        TAPE_REGISTERS[int((word.x >> 10) & 2047u)] = TAPE_APPLY(op, a, b, held_a, held_b);        \
        held_a = TAPE_CHOOSE(op == 1u, a, held_a);                                                 \
        held_b = TAPE_CHOOSE(op == 1u, b, held_b);                                                 \
        ++at;                                                                                      \
    }

void TAPE_RUN(uvec2 span) {
    int at = int(span.x), end = at + int(span.y);
    TAPE_NUMBER held_a = TAPE_NUMBER(0.0), held_b = TAPE_NUMBER(0.0);
#ifdef TAPE_CALL
    // Software renderers run a loop's body once more after a break at its top.
    do {
        uvec2 word = IM_BUFFER_AT(tape_words, at).xy;
        int stop = at + 2 + int(IM_BUFFER_AT(tape_words, at + 1).x);
        at += 2;
        {
            TAPE_OPERANDS
            TAPE_REGISTERS[int((word.x >> 10) & 2047u)] = TAPE_CALL(word.x & 127u, a, b, a, b);
        }
#else
    {
        int stop = end;
#endif
        do {
            TAPE_STEP TAPE_STEP TAPE_STEP TAPE_STEP
            TAPE_STEP TAPE_STEP TAPE_STEP TAPE_STEP
        } while (at < stop);
#ifdef TAPE_CALL
    } while (at < end);
#else
    }
#endif
}
#undef TAPE_OPERANDS
#undef TAPE_STEP

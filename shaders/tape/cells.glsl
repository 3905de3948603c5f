// Finds the tape of a function for a point or a box, src/formula/tape/tape_cells.h, and reads the
// numbers in it.

uniform IM_BUFFER_OF_UINTS tape_words; // instructions, two words each
uniform IM_BUFFER_OF_UINTS tape_spans; // first instruction and number of them

#define TAPE_LOW tape_block[0].xyz
#define TAPE_LEVELS tape_block[0].w
#define TAPE_SIZE tape_block[1].xyz

// The tape of the cell of a level that holds the middle of a box, or of the whole space where the
// box is not within the cell and what is `around` it. `spans`: the first one of the function.
uvec2 tape_of_cell(int spans, float level, float around, vec3 low, vec3 high) {
    float along = exp2(level);
    vec3 side = TAPE_SIZE / along;
    vec3 cell = clamp(floor((0.5 * (low + high) - TAPE_LOW) / side), 0.0, along - 1.0);
    bool within = all(greaterThanEqual(low, TAPE_LOW + (cell - around) * side)) &&
                  all(lessThanEqual(high, TAPE_LOW + (cell + 1.0 + around) * side));
    int n = int(along);
    int place = 1 + (n * n * n - 1) / 7 + (int(cell.z) * n + int(cell.y)) * n + int(cell.x);
    return IM_BUFFER_AT(tape_spans, spans + (within ? place : 0)).xy;
}

// Drops the notes on a cell without roots.
uvec2 without_notes(uvec2 span) {
    return uvec2(span.x, span.y & 0xffffffu);
}

uvec2 tape_at(int spans, vec3 p) {
    return without_notes(tape_of_cell(spans, TAPE_LEVELS, 0.0625, p, p));
}

uvec2 tape_over(int spans, vec2 x, vec2 y, vec2 z) {
    vec3 low = vec3(x.x, y.x, z.x), high = vec3(x.y, y.y, z.y);
    vec3 part = (high - low) / TAPE_SIZE;
    float level = floor(-log2(2.002 * max(part.x, max(part.y, part.z)))); // as half a cell
    return tape_of_cell(spans, clamp(level, 0.0, TAPE_LEVELS), 0.25, low, high);
}

bool tape_is_rough = false; // whether the tape run last met what is not smooth

float tape_float(uvec2 word) {
    return uintBitsToFloat(word.y);
}

// A float, or all numbers up to the next one.
vec2 tape_interval(uvec2 word) {
    uint farther = word.y + 1u, nearer = word.y - 1u;
    uint next = (word.y & 0x80000000u) == 0u ? farther : nearer;
    return vec2(uintBitsToFloat(word.y), uintBitsToFloat((word.x & 512u) != 0u ? next : word.y));
}

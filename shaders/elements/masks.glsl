// Elements of the first array that matter, as bits: element e is bit e & 31 of word e >> 5. Beams
// find them where shaders can write no lists, in GLSL ES; sums over the array go through those
// entered last.
#define LIST uvec4

LIST entered = LIST(0xffffffffu);

LIST entered_list() { return entered; }
void enter_list(LIST list) { entered = list; }

// The bits of a word that stand for elements that there are.
uint listed_bits(int word) {
    int n = clamp(array0_count - 32 * word, 0, 32);
    return n < 32 ? entered[word] & ((1u << uint(n)) - 1u) : entered[word];
}

// The first element of some bits of a word. ES 3.00 has no findLSB(): the exponent of the float that
// a power of two is tells which one it is.
int first_listed(int word, uint bits) {
    float lowest = float(int(bits & (~bits + 1u)));
    return 32 * word + ((floatBitsToInt(lowest) >> 23) & 255) - 127;
}

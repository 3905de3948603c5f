// Makes shaders/tape/run.glsl work on intervals of floats.
#undef TAPE_NUMBER
#undef TAPE_REGISTERS
#undef TAPE_CHOOSE
#define TAPE_NUMBER vec2
#define TAPE_REGISTERS tape_intervals
#define TAPE_CHOOSE IM_SELECT2
#define tape_literal tape_interval

bool tape_is_rough = false; // whether the tape run last met what is not smooth

// A float, or all numbers up to the next one.
vec2 tape_interval(uvec2 word) {
    uint farther = word.y + 1u, nearer = word.y - 1u;
    uint next = (word.y & 0x80000000u) == 0u ? farther : nearer;
    return vec2(uintBitsToFloat(word.y), uintBitsToFloat((word.x & 512u) != 0u ? next : word.y));
}

// Makes shaders/tape/run.glsl work on floats.
#undef TAPE_NUMBER
#undef TAPE_REGISTERS
#undef TAPE_CHOOSE
#define TAPE_NUMBER float
#define TAPE_REGISTERS tape_numbers
#define TAPE_CHOOSE IM_SELECT

float tape_literal(uvec2 word) {
    return uintBitsToFloat(word.y);
}

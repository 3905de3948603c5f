// The part of a sum, relative to its value at roots, that the lists of one level of beams may leave
// out: see march/beam_list.glsl.
#define LEFT_OUT 6.25e-7

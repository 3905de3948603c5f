// What the lists of one level of beams leave out of a sum, of what it is at roots: see
// march/beam_list.glsl.
#define LEFT_OUT 6.25e-7

// Runs rays, or beams, in a fragment shader, or in a compute shader: one invocation per pixel, or block,
// in square work groups.
#ifdef COMPUTE
layout(local_size_x = WORKGROUP_SIDE, local_size_y = WORKGROUP_SIDE) in;

// Graphics cards need no place in (0, 1) for a fetch, nor ask for the texture's size.
#undef IM_TEXEL
#define IM_TEXEL(floats, at) texelFetch(floats, ivec2(at), 0)

vec2 pixel_centre = vec2(gl_GlobalInvocationID.xy) + 0.5; // in the tile, as in fragment shaders
#else
#define pixel_centre gl_FragCoord.xy // from the target's lower left corner
#endif

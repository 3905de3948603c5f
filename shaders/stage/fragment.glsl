// Runs rays, or beams, in a fragment shader. stage/compute.glsl is the counterpart.
#define pixel_centre gl_FragCoord.xy // in the tile, from its lower left corner

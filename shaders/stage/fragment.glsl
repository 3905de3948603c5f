// Runs rays, or beams, in a fragment shader. stage/compute.glsl is the counterpart.
#define pixel_centre gl_FragCoord.xy // from the target's lower left corner

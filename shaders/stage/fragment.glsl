// What rays ask of a fragment shader; stage/compute.glsl is the other stage's answer.
#define pixel_centre gl_FragCoord.xy // in the tile, from its lower left corner

// What beams by models tell of roots: of a settled block the slab that holds them, of any other one in .x the tau
// before which there are none. See beam_by_models.glsl.
uniform sampler2D beam_roots_texture;

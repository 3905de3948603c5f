// The part of a beam that rays need to march, in tau: .x to .y, empty without roots.
uniform sampler2D beam_texture;

vec4 part_of_beam(ivec2 texel) {
    vec4 part = IM_TEXEL(beam_texture, texel);
#ifdef TRIMMED
    // See beam_by_models.glsl.
    vec4 slab = IM_TEXEL(beam_roots_texture, texel);
    part.x = slab.w > 0.0 ? part.x : slab.x;
    part.y = part.w;
#endif
    return part;
}

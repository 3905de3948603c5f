// The part of a beam that rays need to march, in tau: .x to .y, empty without roots.
uniform sampler2D beam_texture;
#ifdef TRIMMED
uniform sampler2D beam_roots_texture; // see slab.glsl
#endif

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

#if defined(LISTS) && !defined(COPIES)
// Its lists of the elements that matter in its front, its middle and all of it.
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;

LIST front_of_beam(ivec2 at) { return IM_TEXEL(beam_lists_texture, at).xy; }
LIST middle_of_beam(ivec2 at) { return IM_TEXEL(beam_lists_texture, at).zw; }
LIST all_of_beam(ivec2 at) { return IM_TEXEL(beam_all_texture, at).xy; }
#endif

// The part of a beam that rays need to march, in tau: .x to .y, empty without roots.
uniform sampler2D beam_texture;

vec4 part_of_beam(ivec2 texel) {
    vec4 part = IM_TEXEL(beam_texture, texel);
#ifdef TRIMMED
    part.y = part.w; // see beam_by_models.frag
#endif
    return part;
}

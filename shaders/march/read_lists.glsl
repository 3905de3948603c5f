// Loads a beam's lists of the elements that matter in its front, its middle and all of it.
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;

LIST front_of_beam(ivec2 at) { return IM_TEXEL(beam_lists_texture, at).xy; }
LIST middle_of_beam(ivec2 at) { return IM_TEXEL(beam_lists_texture, at).zw; }
LIST all_of_beam(ivec2 at) { return IM_TEXEL(beam_all_texture, at).xy; }

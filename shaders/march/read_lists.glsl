// Loads a beam's lists of the elements that matter in its front, its middle and all of it.
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;

LIST front_of_beam(ivec2 at) { return texelFetch(beam_lists_texture, at, 0).xy; }
LIST middle_of_beam(ivec2 at) { return texelFetch(beam_lists_texture, at, 0).zw; }
LIST all_of_beam(ivec2 at) { return texelFetch(beam_all_texture, at, 0).xy; }

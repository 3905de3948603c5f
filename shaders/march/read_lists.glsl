// What beams found to matter in them: elements of their front, of their middle and of all.
uniform sampler2D beam_lists_texture;
uniform sampler2D beam_all_texture;

LIST front_of_beam(ivec2 at) { return texelFetch(beam_lists_texture, at, 0).xy; }
LIST middle_of_beam(ivec2 at) { return texelFetch(beam_lists_texture, at, 0).zw; }
LIST all_of_beam(ivec2 at) { return texelFetch(beam_all_texture, at, 0).xy; }

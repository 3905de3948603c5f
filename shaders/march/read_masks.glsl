// What beams found to matter in them: elements of their front, of their middle and of all.
uniform usampler2D beam_front_texture;
uniform usampler2D beam_middle_texture;
uniform usampler2D beam_all_texture;

LIST front_of_beam(ivec2 at) { return texelFetch(beam_front_texture, at, 0); }
LIST middle_of_beam(ivec2 at) { return texelFetch(beam_middle_texture, at, 0); }
LIST all_of_beam(ivec2 at) { return texelFetch(beam_all_texture, at, 0); }

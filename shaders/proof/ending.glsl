// How the ray of a pixel ended, as the picture has it.
uniform usampler2D record_texture; // shade/record.glsl
uniform sampler2D ending_texture;  // channels/ending.glsl

struct Ending {
    bool hit, miss; // or neither
    float t;        // of a hit
};

Ending load_ending() {
    ivec2 at = ivec2(pixel_centre);
    int verdict = int(texelFetch(record_texture, at, 0).x & 7u);
    return Ending(verdict == VERDICT_HIT || verdict == VERDICT_ZERO_GRADIENT,
                  verdict == VERDICT_MISS, texelFetch(ending_texture, at, 0).x);
}

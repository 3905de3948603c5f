// The distance to what is seen of the surfaces before this one, where each surface draws over the
// ones before.
uniform sampler2D way_texture;

float way_before() {
    return texelFetch(way_texture, ivec2(pixel_centre), 0).x;
}

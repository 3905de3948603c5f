// How far what is seen of the surfaces before this one is, where each draws over those.
uniform sampler2D way_texture;

float way_before() {
    return texelFetch(way_texture, ivec2(pixel_centre), 0).x;
}

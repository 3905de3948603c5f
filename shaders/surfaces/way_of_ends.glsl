// The distance to the nearest end on the surfaces before this one.
uniform sampler2D surface_texture_3;

float way_before() {
    return texelFetch(surface_texture_3, ivec2(pixel_centre), 0).x;
}

// Loads the end of a pixel's ray. Needs surface_point.glsl.
uniform sampler2D surface_texture_0;
uniform sampler2D surface_texture_1;
uniform sampler2D surface_texture_2;

SurfacePoint load_surface() {
    ivec2 at = ivec2(pixel_centre);
    return unpack_surface(IM_TEXEL(surface_texture_0, at),
                          IM_TEXEL(surface_texture_1, at),
                          IM_TEXEL(surface_texture_2, at));
}

// Loads the ends of mirrored rays. Needs surface_point.glsl.
uniform sampler2D mirrored_texture_0;
uniform sampler2D mirrored_texture_1;
uniform sampler2D mirrored_texture_2;

SurfacePoint load_mirrored() {
    ivec2 at = ivec2(pixel_centre);
    return unpack_surface(IM_TEXEL(mirrored_texture_0, at),
                          IM_TEXEL(mirrored_texture_1, at),
                          IM_TEXEL(mirrored_texture_2, at));
}

// Loads the end of a pixel's ray. Needs surface_point.glsl.
uniform sampler2D surface_texture_0;
uniform sampler2D surface_texture_1;
uniform sampler2D surface_texture_2;

SurfacePoint stored_surface() {
    ivec2 at = ivec2(pixel_centre);
    return unpack_surface(IM_TEXEL(surface_texture_0, at),
                          IM_TEXEL(surface_texture_1, at),
                          IM_TEXEL(surface_texture_2, at));
}

#ifdef MOVED_ENDS
// In the formula coordinates of this surface; stored_surface() has those of the surface that it is on.
// SURFACES is their number.
uniform sampler2D surface_texture_3;
uniform vec4 surface_moves[3 * SURFACES]; // three rows for each, from its coordinates to these

SurfacePoint load_surface() {
    SurfacePoint p = stored_surface();
    int k = 3 * int(IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).z);
    vec4 x = surface_moves[k], y = surface_moves[k + 1], z = surface_moves[k + 2];
    float scale = length(x.xyz);
    vec4 at = vec4(p.position, 1.0);
    p.position = vec3(dot(x, at), dot(y, at), dot(z, at));
    p.normal = vec3(dot(x.xyz, p.normal), dot(y.xyz, p.normal), dot(z.xyz, p.normal)) / scale;
    p.offset *= scale;
    p.pixel *= scale;
    return p;
}
#else
SurfacePoint load_surface() {
    return stored_surface();
}
#endif

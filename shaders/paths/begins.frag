// Writes as depth whether a path begins at the pixel: where the eye's ray ended on this surface, or begins
// in glass, or enters it at bounds. See march/mask.frag.
uniform sampler2D surface_texture_1;
uniform sampler2D surface_texture_3;
uniform sampler2D surface_texture_4; // see bounds.glsl

void main() {
    ivec2 at = ivec2(pixel_centre);
    vec4 end = IM_TEXEL(surface_texture_3, at), begin = IM_TEXEL(surface_texture_4, at);
    int verdict = int(IM_TEXEL(surface_texture_1, at).w) & 7;
    bool is_in_glass = begin.y > 0.0 && begin.x < end.x;
    gl_FragDepth = int(end.z) == SURFACE && (on_surface(verdict) || is_in_glass) ? 1.0 : 0.0;
}

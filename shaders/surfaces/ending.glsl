// channels/ending.glsl where surfaces share the way along a ray: the place is that on the first one's.
layout(location = ENDING_LOCATION) out float ending_out;

void write_ending(Ray ray, Hit hit, int verdict) {
    float way = texelFetch(surface_texture_3, ivec2(pixel_centre), 0).x;
    ending_out = on_surface(verdict) ? way : verdict == VERDICT_MISS ? ENDS_NOWHERE : ENDS_UNKNOWN;
}

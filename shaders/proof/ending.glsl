// Loads how the rays of pixels ended, from the picture's channel: shade/channels.glsl.
uniform sampler2D ending_texture;

struct Ending {
    bool hit, miss; // or neither
    float t;        // of a hit
};

Ending load_ending(ivec2 pixel) {
    float t = IM_TEXEL(ending_texture, pixel).x;
    return Ending(abs(t) < ENDS_NOWHERE, t >= ENDS_NOWHERE, t);
}

#ifdef ENDED_RAYS
// Rays among several surfaces end where another one is seen: see ending_of_surface.frag.
Ray pixel_ray() {
    Ray ray = eye_ray();
    ray.t_far = min(ray.t_far, IM_TEXEL(ending_texture, ivec2(pixel_centre)).y);
    return ray;
}
#endif

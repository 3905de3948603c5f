// The place on a pixel's ray as all surfaces have it: t of the first surface's ray. Rays of all
// surfaces are one in the world, and begin at planes of their own; those that begin on a surface begin
// at one place.
uniform vec4 surface_way; // lengths of this surface's formula in the first one's; between the planes

const float NO_END = 1.0e30;

float shared_way(Ray ray, float t) {
#ifdef EYE_RAYS
    return surface_way.x * t + surface_way.y * ray.to_eye;
#else
    return surface_way.x * t;
#endif
}

#ifdef WAY_LOCATION
// The distance to what is seen of the surfaces so far.
layout(location = WAY_LOCATION) out float way;

#endif
#ifdef ENDS_BEFORE
// The distance to what is seen of the surfaces before this one.
#ifdef DRAWS_AT_ONCE
uniform sampler2D way_texture;

float way_before() {
    return IM_TEXEL(way_texture, ivec2(pixel_centre)).x;
}
#else
uniform sampler2D surface_texture_3;

float way_before() {
    return IM_TEXEL(surface_texture_3, ivec2(pixel_centre)).x;
}
#endif
#endif

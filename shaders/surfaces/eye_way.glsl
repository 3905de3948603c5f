// The place on a pixel's ray as all surfaces have it: t of the first surface's ray. Rays of all
// surfaces are one in the world, and begin at planes of their own.
uniform vec4 surface_way; // lengths of this surface's formula in the first one's; between the planes

float shared_way(Ray ray, float t) {
    return surface_way.x * t + surface_way.y * ray.to_eye;
}

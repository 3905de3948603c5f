// Only rays that end on a surface which mirrors the others go on: MIRRORS has a bit for each of those.
Ray pixel_ray() {
    Ray ray = mirrored_ray();
    int k = int(texelFetch(surface_texture_3, ivec2(pixel_centre), 0).z);
    if (((MIRRORS >> k) & 1) == 0) ray.t_far = -1.0;
    return ray;
}

// Light at a place of glass: the reflected part sees what is around, the rest, or all where reflection
// is total, is followed. Needs matter.glsl, path.glsl, end_of_ray.glsl and seen_around().

// `in_glass`: how far the ray to p went through it. `part`: of what is not reflected, how much goes on.
Path through(Path path, SurfacePoint p, float in_glass, float part) {
    Refraction is = refraction_at(p, path.direction);
    bool total = is.reflected >= 1.0;
    vec3 mirrored = reflect(path.direction, p.normal);
    if (!total) {
        // Within glass the reflected part goes about as far again, and leaves on the other side: as
        // in a plate, by the mirror image of how the rest leaves.
        vec3 seen = p.inside ? reflect(is.direction, p.normal) : mirrored;
        vec3 again = p.inside ? absorbed(in_glass) : vec3(1.0);
        path.light += path.weight * again * is.reflected * seen_around(p.position, seen);
        path.weight *= (1.0 - is.reflected) * part;
        p.normal = -p.normal;
        p.inside = !p.inside;
    }
    path.direction = total ? mirrored : is.direction;
    float offset = offset_from(p);
#ifdef SECTIONS
    if (p.cap >= 0) offset = offset_from_cap(p.position, p.normal, p.cap, p.inside, p.pixel);
#endif
    // As far off the surface, but on the ray itself, unless that is nearly along the surface.
    float rise = dot(p.normal, path.direction);
    path.off = offset / max(rise, 0.25);
    path.position = p.position + (offset - path.off * rise) * p.normal;
    path.state = p.inside ? PATH_IN_GLASS : PATH_OUTSIDE;
    return path;
}

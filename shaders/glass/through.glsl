// Splits light at a point of glass. The reflected part sees the surroundings; the path follows the
// rest, or all if reflection is total. Needs refraction.glsl, path.glsl, end_of_ray.glsl
// and seen_around().

// `faded`: what is left of light on the ray to p. `part`: share of the unreflected light that goes on.
Path through(Path path, SurfacePoint p, float index, vec3 faded, float part) {
    Refraction is = refraction_at(p, path.direction, index);
    bool total = is.reflected >= 1.0;
    vec3 mirrored = reflect(path.direction, p.normal);
    if (!total) {
        // Inside, the reflected part travels about as far again and leaves on the other side. As in
        // a plate, it leaves along the mirror image of the refracted direction.
        vec3 seen = p.inside ? reflect(is.direction, p.normal) : mirrored;
        vec3 again = p.inside ? faded : vec3(1.0);
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
    // Starts as far off the surface, but on the ray itself, unless the ray grazes the surface.
    float rise = dot(p.normal, path.direction);
    path.off = offset / max(rise, 0.25);
    path.position = p.position + (offset - path.off * rise) * p.normal;
    path.state = p.inside ? PATH_IN_GLASS : PATH_OUTSIDE;
    return path;
}

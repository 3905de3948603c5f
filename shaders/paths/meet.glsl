// Continues a path where it met this surface, or ends it there. `way`: of its ray. `is_first`: it is the
// eye's ray, of whose end shade() tells the colour. Needs path.glsl, matter.glsl and
// glass/surroundings.glsl.

#if defined(GLASS)
// The surface of glass: glass/through.glsl, between any two kinds of matter. Needs lit_again().
uniform sampler2D beyond_texture; // see beyond.frag

int matter_beyond() {
    return int(IM_TEXEL(beyond_texture, ivec2(pixel_centre)).x) - 1;
}

Path meet(Path path, SurfacePoint p, float way, bool is_first) {
    int beyond = matter_beyond();
    float within = index_of(p.inside ? path.matter : beyond);
    float outside = index_of(p.inside ? beyond : path.matter);
    float index = within / outside;
    vec3 faded = absorbed_in(path.matter, way);
    float beside = beside_reflection(refraction_at(p, path.direction, index).reflected);
    if (is_first) {
        path.own = beside;
    } else {
        path.rays_left -= 1;
        if (!p.inside) path.light += path.weight * beside * lit_again(p, hit_of(p), -path.direction);
    }
    path = through(path, p, index, faded, p.inside ? 1.0 : transmission());
    if (dot(path.direction, p.normal) < 0.0) {
        path.matter = beyond;
    } else { // back: what lies on the other side of the glass is not before it
        path.position += path.off * path.direction;
        path.off = 0.0;
    }
    return unless_faint(path, path.rays_left);
}
#elif defined(MIRRORS_ALL)
// A mirror. Needs mirror_weight() and lit_again().
Path meet(Path path, SurfacePoint p, float way, bool is_first) {
    Hit hit = hit_of(p);
    vec3 to_viewer = -path.direction;
    vec3 mirror = mirror_weight(surface_color(hit), p.normal, to_viewer);
    if (!is_first) {
        path.rays_left -= 1;
        path.light += path.weight * beside_mirror(mirror) * lit_again(p, hit, to_viewer);
    }
    path.weight *= mirror;
    path.position = p.position + p.offset * p.normal;
    path.direction = reflect(path.direction, p.normal);
    path.off = 0.0;
    path.state = PATH_OUTSIDE;
    return unless_faint(path, path.rays_left);
}
#else
// Any other surface ends it: seen.frag has the colour.
Path meet(Path path, SurfacePoint p, float way, bool is_first) {
    path.state = is_first ? PATH_ENDED : PATH_ON_SURFACE;
    path.position = p.position;
    path.normal = p.normal;
    path.off = p.offset;
    path.inside = p.inside;
#ifdef SECTIONS
    path.cap = p.cap;
#endif
    return path;
}
#endif

// Keeps what shadow rays and seen.frag ask of an end on the ground.
Path with_ground(Path path) {
#ifdef GROUND
    if (path.state != PATH_ON_GROUND) return path;
    path.normal = ground_normal(path.direction);
    path.off = 0.05 * footprint_at(path.position);
    path.inside = false;
    path.cap = -1;
#endif
    return path;
}

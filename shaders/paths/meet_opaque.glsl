// Ends a path where it met a surface: seen.frag has the colour. For the eye's ray, shade() tells
// it.
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

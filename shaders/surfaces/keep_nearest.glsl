// Keeps what the surfaces before this one drew where this one is not nearer, and adds up the
// evaluations of all. Needs seen_way.glsl, way_before(), keep_channels() and least_nearer().
uniform sampler2D before_texture_0;
uniform usampler2D before_texture_1;

void keep_nearest(Ray ray, RayState s) {
    ivec2 at = ivec2(pixel_centre);
    float others = way_before();
    uint before = texelFetch(before_texture_1, at, 0).x;
    int verdict = int(record & 7u), verdict_before = int(before & 7u);
    bool is_nearer = way < NO_END && way < others - least_nearer(ray_point(ray, s.low));
    if (!is_nearer) {
        color = texelFetch(before_texture_0, at, 0);
        way = others;
        keep_channels(at);
    }
    bool is_unfinished = verdict == VERDICT_UNFINISHED || verdict_before == VERDICT_UNFINISHED;
    verdict = is_unfinished ? VERDICT_UNFINISHED : is_nearer ? verdict : verdict_before;
    record = packed_record(verdict, s.evaluations + int(before >> 3));
}

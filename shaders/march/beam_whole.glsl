// First level of beams: they search all of the bounds.

Part parent_part(ivec2 block) {
    float first = 0.125 * (beam.y - beam.x);
#ifdef LISTS
    LIST all = entered_list();
    return Part(beam.x, beam.y, first, beam.y, all, all);
#else
    return Part(beam.x, beam.y, first);
#endif
}

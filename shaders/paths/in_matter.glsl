// Whether a place within this surface's bounds is in its matter.
bool is_in_matter(vec3 position) {
#ifdef SECTIONS
    if (sections_value(position) > 0.0) return false;
#endif
    return field(position) < 0.0;
}

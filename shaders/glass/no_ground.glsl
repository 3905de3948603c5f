float ground_ahead(vec3 position, vec3 direction) {
    return -1.0;
}

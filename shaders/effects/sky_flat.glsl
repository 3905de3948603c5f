vec4 sky(vec3 direction) {
    return background;
}

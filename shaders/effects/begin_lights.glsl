// Shadow rays begin with no light hidden.
RayState begin_lights() {
    return state_at(0.0);
}

int evaluations_before() {
    return 0;
}

// Of the elements that matter in a ray's beam: those in its front, and in all of it.
vec4 beam_lists;
float front_end;

// The list for samples at t, or for all up to there.
void choose_list(float t) {
    enter_list(t <= front_end ? beam_lists.xy : beam_lists.zw);
}

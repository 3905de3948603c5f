// Lists of the elements that matter in a ray's beam: in its front, on to the end of its middle, and in
// all of it; with where front and middle end.
struct BeamLists {
    LIST front, middle, all;
    float front_end, middle_end;
};
BeamLists beam_lists;

// The list for samples at t, or for all up to there.
void choose_list(float t) {
    LIST list = t <= beam_lists.middle_end ? beam_lists.middle : beam_lists.all;
    enter_list(t <= beam_lists.front_end ? beam_lists.front : list);
}

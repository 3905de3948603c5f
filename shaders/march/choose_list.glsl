// The lists of elements of a ray's beam: for its front, up to the end of its middle, and for all of
// it. front_end and middle_end are in t.
struct BeamLists {
    LIST front, middle, all;
    float front_end, middle_end;
};
BeamLists beam_lists;

// Enters the list for samples up to t.
void choose_list(float t) {
    LIST list = t <= beam_lists.middle_end ? beam_lists.middle : beam_lists.all;
    enter_list(t <= beam_lists.front_end ? beam_lists.front : list);
}

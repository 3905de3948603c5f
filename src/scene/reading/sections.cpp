#include "scene/reading/sections.h"

#include "scene/key_tables.h"
#include "scene/limits.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {
namespace {

Cut read_cut(Section section, TrackTable& tracks) {
    Cut cut;
    cut.is_ball = section.has("sphere");
    if (section.has("normal") == cut.is_ball) {
        section.tell("needs one of normal = [x, y, z], which points to the half-space that is "
                     "taken away, and sphere = radius of a ball that is");
        pass_over(keys::plane_keys, section);
        pass_over(keys::cut_ball_keys, section);
        cut = {.is_ball = true, .centre = tracks.add(section.full_name("centre"), 0, 0, 0)};
        cut.radius = cut.centre[0];
    } else if (cut.is_ball) {
        read_keys(keys::cut_ball_keys, section, cut, tracks);
        refuse_keys(keys::plane_keys, section,
                    "is of a half-space, which has a normal; of a ball give centre = [x, y, z]");
    } else {
        read_keys(keys::plane_keys, section, cut, tracks);
        refuse_keys(keys::cut_ball_keys, section,
                    "is of a ball; of a half-space give point = [x, y, z] on its plane");
    }
    section.refuse_rest();
    return cut;
}

} // namespace

std::vector<Cut> read_sections(Section& document, TrackTable& tracks) {
    std::vector<Cut> cuts;
    for (const Section& section : document.list("sections", "section", limits::sections))
        cuts.push_back(read_cut(section, tracks));
    return cuts;
}

} // namespace isomotion::scene

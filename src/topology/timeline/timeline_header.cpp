#include "topology/timeline/timeline_header.h"

#include <cctype>
#include <set>

#include "base/fingerprint.h"
#include "scene/scene_at.h"
#include "scene/source_print.h"

namespace isomotion::topology {
namespace {

using animation::Animation;
using base::Fingerprint;

// Tracks that something in the formula's surface moves by, what their expressions name included.
class Needed {
public:
    explicit Needed(const Animation& animation)
        : animation_(animation) {}

    void track(int id) {
        if (!tracks_.insert(id).second) return;
        const auto& source = animation_.tracks()[std::size_t(id)].source;
        if (const auto* expression = std::get_if<animation::Expression>(&source)) {
            text(expression->text);
        }
    }
    // Every word that is a track's name: a word that stands for something else at most makes the
    // fingerprint depend on too much.
    void text(std::string_view expression) {
        const auto part = [](char c) {
            return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
        };
        for (std::size_t k = 0; k < expression.size();) {
            std::size_t end = k;
            while (end < expression.size() && part(expression[end])) ++end;
            if (end > k) {
                if (const auto id = animation_.find(expression.substr(k, end - k))) track(*id);
            }
            k = end + 1;
        }
    }
    const std::set<int>& tracks() const { return tracks_; }

private:
    const Animation& animation_;
    std::set<int> tracks_;
};

TimelineHeader::Box box_of(const scene::BoundsAt& bounds, const std::array<double, 3>& origin) {
    TimelineHeader::Box box;
    for (int k = 0; k < 3; ++k) {
        const double from = origin[std::size_t(k)];
        box[std::size_t(k)] = {from + bounds.min[k], from + bounds.max[k]};
    }
    return box;
}

// The fingerprint of what determines topology and, if it counts, of the placement.
std::string fingerprint_of(const scene::OneSurface& one, bool with_placement) {
    const Animation& animation = one.surface.animation;
    const scene::Bounds& bounds = one.surface.bounds;
    Needed needed(animation);
    for (int id = 0; id < one.surface.parameters; ++id) needed.track(id);
    for (const animation::Array& array : animation.arrays()) {
        for (const animation::ArrayField& field : array.fields) {
            if (const auto* expression = std::get_if<animation::Expression>(&field.source)) {
                needed.text(expression->text);
            }
        }
    }
    std::vector<scene::TrackId> placed;
    if (bounds.shape == scene::Bounds::Shape::box) {
        placed.insert(placed.end(), bounds.min.begin(), bounds.min.end());
        placed.insert(placed.end(), bounds.max.begin(), bounds.max.end());
    } else {
        placed.insert(placed.end(), bounds.centre.begin(), bounds.centre.end());
        placed.push_back(bounds.radius);
    }
    if (with_placement) {
        const scene::Placement& placement = one.surface.placement;
        placed.insert(placed.end(), placement.translate.begin(), placement.translate.end());
        placed.insert(placed.end(), placement.rotate.begin(), placement.rotate.end());
        placed.push_back(placement.scale);
    }
    for (const scene::TrackId id : placed) needed.track(id);

    Fingerprint print;
    print.add("isomotion topology 1").add(formula::identity(*one.surface.field));
    print.add(std::to_string(animation.seed())).add(std::to_string(one.surface.parameters));
    print.add(std::to_string(int(bounds.shape)));
    for (const int id : needed.tracks()) {
        scene::add(print, animation.tracks()[std::size_t(id)]);
    }
    for (std::size_t a = 0; a < animation.arrays().size(); ++a)
        scene::add_array(print, animation, a);
    return print.text();
}

} // namespace

std::string fingerprint(const scene::OneSurface& one) { return fingerprint_of(one, false); }

TimelineHeader header_of(const scene::OneSurface& one, formula::Interval range) {
    const auto bounds = [&](double time) {
        return box_of(scene::surface_at(one, time).bounds, one.surface.field->origin.point);
    };
    return {one.scene.title,
            fingerprint(one),
            one.scene.timeline.fps,
            one.surface.bounds.shape,
            bounds(range.lo),
            bounds(range.hi),
            {}};
}

TimelineHeader header_of_contact(const scene::OneSurface& first, const scene::OneSurface& second,
                                 std::string title, formula::Interval range) {
    TimelineHeader header = header_of(first, range);
    header_of(second, range); // throws if its values are out of their range
    Fingerprint print;
    print.add("isomotion contact 1").add(fingerprint_of(first, true));
    print.add(fingerprint_of(second, true));
    header.title = std::move(title);
    header.fingerprint = print.text();
    return header;
}

} // namespace isomotion::topology

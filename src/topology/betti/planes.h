// The planes across one axis that bound the leaves of an octree. With those across the other axes
// they are a rectilinear grid in which each leaf is a union of boxes: fine only where leaves are.
#pragma once

#include <vector>

namespace isomotion::topology {

// Places are counted in 2^-deepest of the side of the octree's box.
class Planes {
public:
    static constexpr int deepest = 14;
    static constexpr int whole = 1 << deepest;

    Planes()
        : is_one_(whole + 1, false) {
        is_one_.front() = is_one_.back() = true;
    }

    // The place of the plane with this number among those of a depth.
    static int place(int index, int depth) { return index << (deepest - depth); }

    void add(int place) { is_one_[std::size_t(place)] = true; }
    // Call this once all planes are added.
    void number() {
        for (int place = 0; place <= whole; ++place) {
            numbers_.push_back(int(places_.size()));
            if (is_one_[std::size_t(place)]) places_.push_back(place);
        }
    }
    int count() const { return int(places_.size()); }
    int number_of(int place) const { return numbers_[std::size_t(place)]; }
    int place_of(int number) const { return places_[std::size_t(number)]; }

private:
    std::vector<bool> is_one_;
    std::vector<int> places_, numbers_;
};

} // namespace isomotion::topology

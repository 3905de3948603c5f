// An animation in a few words, and the value of one of its tracks or fields.
#pragma once

#include <string>
#include <vector>

#include "animation/animation.h"
#include "unit/formula/testing.h"

namespace isomotion::animation {

using formula::Random;

inline Track track(const std::string& name, const std::string& expression) {
    return {name, Expression{expression}};
}

inline ArrayField field(const std::string& name, const std::string& expression) {
    return {name, Expression{expression}};
}

inline double value(const Animation& animation, const std::string& name, double time) {
    return animation.at(time).tracks.at(std::size_t(animation.find(name).value()));
}

// The first array's field `index`.
inline std::vector<double> column(const Animation& animation, std::size_t index, double time) {
    return animation.at(time).arrays.at(0).fields.at(index);
}

// Who is wrong, and how.
struct Complaint {
    std::string owner, message;
};

inline Complaint complaint(std::vector<Track> tracks, std::vector<Array> arrays = {}) {
    try {
        const Animation animation(std::move(tracks), std::move(arrays));
    } catch (const ExpressionError& error) {
        return {error.owner(), error.what()};
    }
    return {"nobody", "nothing is wrong"};
}

} // namespace isomotion::animation

// How long the rest of a frame will take.
#pragma once

#include <chrono>
#include <optional>

namespace isomotion::sequence {

// A frame's first two parts may compile shaders, so later ones tell the pace; before the third,
// nobody knows it.
class Pace {
public:
    using Seconds = std::chrono::duration<double>;

    // `part` of the frame is drawn after the time `passed`. Parts rise.
    void note(double part, Seconds passed);
    std::optional<Seconds> left(Seconds passed) const;

private:
    int compiling_ = 2; // parts yet
    double begin_ = 0, part_ = 0;
    Seconds at_begin_{}, at_part_{};
};

} // namespace isomotion::sequence

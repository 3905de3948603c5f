// The elements of an array at some times, as a simulation writes them, and between those times.
//
// An element that is in two neighbouring samples moves from one place to the other. One without a
// successor stays where it was until the next sample; one without a predecessor appears at its
// sample. So the number of elements changes at samples only.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "formula/evaluate/evaluate.h"

namespace isomotion::animation {

class ElementSamples {
public:
    enum class Interpolation { linear, hold };

    // The table, row by row; each row is one element at one time.
    struct Rows {
        std::vector<double> times;      // of the samples, ascending, at least one
        std::vector<std::size_t> begin; // first row of each sample, and the end of the last
        std::vector<std::vector<double>> values; // [column][row]
        // Identify elements, unique within a sample. Without any, the k-th element of a sample is
        // the k-th of the next.
        std::vector<std::int64_t> ids;
    };

    ElementSamples(Rows rows, Interpolation interpolation);

    // Outside the samples, the first or the last one. Elements come in the order of the sample at
    // or before `time`; at a sample's own time its values are exact.
    formula::ArrayColumns<double> at(double time) const;

    // How elements move between two neighbouring samples: from `begin` to `end`, in a straight
    // line.
    struct Span {
        formula::ArrayColumns<double> begin, end; // one that stays has the same in both
        double begin_time = 0, end_time = 0;
    };
    // Between the samples around `time`; before the first and after the last nothing moves.
    Span span(double time) const;

    const std::vector<double>& times() const { return rows_.times; }
    // Whether values jump at sample k: elements appear, disappear or are held until it.
    bool jumps(std::size_t k) const;
    // Whether there are more or fewer elements at sample k than before it.
    bool recounts(std::size_t k) const;
    // Whether an element that stays is in another row at sample k than before it. Its own values
    // don't jump for that; what is computed from the row's number does.
    bool reorders(std::size_t k) const;

    int most() const; // elements at one time
    double first_time() const { return rows_.times.front(); }
    double last_time() const { return rows_.times.back(); }
    const Rows& rows() const { return rows_; }
    Interpolation interpolation() const { return interpolation_; }

private:
    static constexpr std::size_t none = std::size_t(-1);

    Rows rows_;
    Interpolation interpolation_;
    std::vector<std::size_t> successor_; // of each row: the row of the same element one sample on
};

} // namespace isomotion::animation

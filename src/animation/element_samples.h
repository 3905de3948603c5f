// The elements of an array at the sampled times of a simulation, and between these times.
//
// An element that is in two successive samples moves from one place to the other. One without a
// successor stays in place until the next sample or, if velocities are known, continues at its
// velocity. One without a predecessor appears at its sample. So the number of elements changes only
// at samples.
#pragma once

#include <cstdint>
#include <mutex>
#include <optional>
#include <string>
#include <vector>

#include "animation/sample_table.h"
#include "formula/evaluate/evaluate.h"

namespace isomotion::animation {

class ElementSamples {
public:
    // The interpolation between samples. `hermite` uses velocities for the columns that have some,
    // and treats the others as `linear` does.
    enum class Interpolation { linear, hold, hermite };
    using Rows = SampleRows;

    ElementSamples(Rows rows, Interpolation interpolation);
    ElementSamples(std::shared_ptr<const SampleSource> source, Interpolation interpolation);

    // A copy with a column's values multiplied.
    ElementSamples multiplied(std::size_t column, double factor) const;
    // A copy in which only these columns have values; the others are empty and never read.
    ElementSamples only(std::vector<bool> columns) const;

    // Outside of the samples, the first or the last one. Elements are in the order of the sample at
    // or before `time`; at a sample's own time its values are exact.
    formula::ArrayColumns<double> at(double time) const;

    // The motion of elements between two successive samples: the values at both of them, and for
    // columns with is_curved() the velocities there, as changes per span. An element without a
    // successor ends where it stays, or where its velocity takes it.
    using Columns = std::vector<std::vector<double>>; // [column][row]
    struct Span {
        formula::ArrayColumns<double> begin;
        Columns end;                          // rows as in `begin`
        Columns begin_velocity, end_velocity; // for columns with is_curved(), else empty
        double begin_time = 0, end_time = 0;
    };
    // The span around `time`; before the first sample and after the last nothing moves.
    Span span(double time) const;
    // The times of those samples; equal times where nothing moves.
    std::pair<double, double> ends(double time) const;
    int count(double time) const;
    // The sample at or before `time`, or the first.
    std::size_t sample_at(double time) const;
    // Whether a column's values may move other than linearly between samples.
    bool is_curved(std::size_t column) const;

    const std::vector<double>& times() const { return source_->times(); }
    // Whether values jump at sample k: elements appear, disappear or are held until it.
    bool jumps(std::size_t k) const;
    // Whether the number of elements changes at sample k.
    bool recounts(std::size_t k) const;
    // Whether an element that stays changes its row at sample k. Its own values don't jump by that,
    // but values computed from the row's number do.
    bool reorders(std::size_t k) const;

    int most() const { return source_->most(); } // elements at one time
    double first_time() const { return times().front(); }
    double last_time() const { return times().back(); }
    Interpolation interpolation() const { return interpolation_; }
    const SampleSource& source() const { return *source_; }

    // Add a column's values, and all times, ids and rules, to a fingerprint.
    void add_column(base::Fingerprint& print, std::size_t column) const;
    void add_rows(base::Fingerprint& print) const;

private:
    struct Pair; // the samples around a time
    struct Change {
        bool jumps = false, recounts = false, reorders = false;
    };
    // Known changes, kept since samples may be expensive to read.
    struct Memo {
        std::mutex mutex;
        std::vector<std::optional<Change>> changes;
    };

    // The column with the velocity by which a column's values move.
    std::optional<std::size_t> velocity_of(std::size_t column) const;
    // The velocities of a column with is_curved(), one for each row; of others none.
    std::span<const double> velocities(const SampleSource::Sample& sample,
                                       std::size_t column) const;
    std::vector<double> exact(const SampleSource::Sample& sample, std::size_t column) const;
    Pair pair(double time) const;
    std::vector<bool> needed() const;
    Change change(std::size_t k) const;
    Change find_change(std::size_t k) const;
    void forget();

    std::shared_ptr<const SampleSource> source_;
    Interpolation interpolation_;
    std::vector<bool> reads_;     // of the columns
    std::vector<double> factors_; // of the columns
    std::shared_ptr<Memo> memo_;
};

} // namespace isomotion::animation

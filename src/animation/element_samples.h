// The elements of an array at some times, as a simulation writes them, and between those times.
//
// An element that is in two neighbouring samples moves from one place to the other. One without a
// successor stays where it was until the next sample, or goes on as fast as it was where velocities
// are known; one without a predecessor appears at its sample. So the number of elements changes at
// samples only.
#pragma once

#include <cstdint>
#include <mutex>
#include <string>
#include <vector>

#include "animation/sample_table.h"
#include "formula/evaluate/evaluate.h"

namespace isomotion::animation {

class ElementSamples {
public:
    // How values go from sample to sample; `hermite` takes velocities in, of the columns that have
    // some, and moves the others as `linear` does.
    enum class Interpolation { linear, hold, hermite };
    using Rows = SampleRows;

    ElementSamples(Rows rows, Interpolation interpolation);
    ElementSamples(std::shared_ptr<const SampleSource> source, Interpolation interpolation);

    // The same, but a column's values multiplied.
    ElementSamples multiplied(std::size_t column, double factor) const;
    // The same, but only these columns have values; the others are empty, and never read.
    ElementSamples only(std::vector<bool> columns) const;

    // Outside the samples, the first or the last one. Elements come in the order of the sample at
    // or before `time`; at a sample's own time its values are exact.
    formula::ArrayColumns<double> at(double time) const;

    // How elements move between two neighbouring samples. With u from 0 to 1, a value is
    // begin + u (way + u (square + u cube)).
    struct Span {
        formula::ArrayColumns<double> begin;
        std::vector<std::vector<double>> way;          // [column][row], as the next
        std::vector<std::vector<double>> square, cube; // of columns that is_curved(); else empty
        double begin_time = 0, end_time = 0;
    };
    // Between the samples around `time`; before the first and after the last nothing moves.
    Span span(double time) const;
    // The times of those samples, once more the same where nothing moves.
    std::pair<double, double> ends(double time) const;
    int count(double time) const;
    // The sample at or before `time`, or the first.
    std::size_t sample_at(double time) const;
    // Whether a column's values may go otherwise than straight from sample to sample.
    bool is_curved(std::size_t column) const;

    const std::vector<double>& times() const { return source_->times(); }
    // Whether values jump at sample k: elements appear, disappear or are held until it.
    bool jumps(std::size_t k) const;
    // Whether there are more or fewer elements at sample k than before it.
    bool recounts(std::size_t k) const;
    // Whether an element that stays is in another row at sample k than before it. Its own values
    // don't jump for that; what is computed from the row's number does.
    bool reorders(std::size_t k) const;

    int most() const { return source_->most(); } // elements at one time
    double first_time() const { return times().front(); }
    double last_time() const { return times().back(); }
    Interpolation interpolation() const { return interpolation_; }
    const SampleSource& source() const { return *source_; }

    // Of a column's values, and of all times, ids and rules.
    void add_column(base::Fingerprint& print, std::size_t column) const;
    void add_rows(base::Fingerprint& print) const;

private:
    struct Pair; // the samples around a time
    struct Change {
        bool jumps = false, recounts = false, reorders = false;
    };
    // What was found out of changes: samples may be far away.
    struct Memo {
        std::mutex mutex;
        std::vector<std::optional<Change>> changes;
    };

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

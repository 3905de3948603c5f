// The source of an array's elements at the sampled times: a table in memory, or one file per time.
// The same question always has the same answer. Any thread may ask.
#pragma once

#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/fingerprint.h"

namespace isomotion::animation {

class SampleSource {
public:
    // The elements at one time. The data lives as long as `keep` and the source.
    struct Sample {
        std::size_t count = 0;
        std::vector<std::span<const double>> columns; // empty for columns that were not asked for
        std::shared_ptr<const void> keep{};
    };

    // For each row of a sample, the row of the same element in the next sample.
    class Successors {
    public:
        static constexpr std::uint32_t none = std::uint32_t(-1); // the element has disappeared

        // The first `both` rows keep their row.
        explicit Successors(std::size_t both)
            : both_(both) {}
        Successors(std::span<const std::uint32_t> rows, std::shared_ptr<const void> keep)
            : rows_(rows)
            , keep_(std::move(keep)) {}

        std::uint32_t of(std::size_t row) const {
            if (row < rows_.size()) return rows_[row];
            return row < both_ ? std::uint32_t(row) : none;
        }

    private:
        std::span<const std::uint32_t> rows_;
        std::size_t both_ = 0;
        std::shared_ptr<const void> keep_;
    };

    virtual ~SampleSource() = default;

    // Times of the samples, ascending, at least one.
    virtual const std::vector<double>& times() const = 0;
    virtual std::size_t columns() const = 0;
    // `columns`: those that are needed.
    virtual Sample sample(std::size_t k, const std::vector<bool>& columns) const = 0;
    // For the rows of sample k, which is not the last.
    virtual Successors successors(std::size_t k) const = 0;
    virtual int most() const = 0; // elements at one time
    // The column with the velocity of another, in that column's units per second.
    virtual std::optional<std::size_t> velocity_of(std::size_t column) const = 0;

    // Fingerprints of the samples' content, not of the place where it is stored.
    virtual void add_column(base::Fingerprint& print, std::size_t column) const = 0;
    virtual void add_rows(base::Fingerprint& print) const = 0;

    // For people: the origin of sample k ("p.0007.ply: PLY, ascii; 1 of 90 files"), and the names
    // of its columns there.
    virtual std::string origin(std::size_t k) const = 0;
    virtual std::vector<std::string> names() const = 0;
    // The files that the samples are read from.
    virtual std::vector<std::filesystem::path> files() const = 0;
    // Throws if any of them changed since the source was made, where samples are read one by one:
    // what was made of them may be of two simulations.
    virtual void expect_unchanged() const {}

protected:
    SampleSource() = default;
    SampleSource(const SampleSource&) = default;
    SampleSource& operator=(const SampleSource&) = default;
};

// Matches the rows of one sample to those of the next by the ids of their elements. Ids are unique
// within each sample.
std::vector<std::uint32_t> match(std::span<const std::int64_t> here,
                                 std::span<const std::int64_t> there);

// The first row with the id of an earlier row, and that earlier row.
struct Twins {
    std::size_t first = 0, second = 0;
};
std::optional<Twins> find_twins(std::span<const std::int64_t> ids);

} // namespace isomotion::animation

// Where the elements of an array at some times come from: a table in memory, or a file for each
// time. The same question always has the same answer; it may come from any thread.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "base/fingerprint.h"

namespace isomotion::animation {

class SampleSource {
public:
    // The elements at one time. What it refers to lives as long as `keep` and the source.
    struct Sample {
        std::size_t count = 0;
        std::vector<std::span<const double>> columns; // those that were not asked for are empty
        std::shared_ptr<const void> keep{};
    };

    // Of each row of a sample, the row of the same element in the next one.
    class Successors {
    public:
        static constexpr std::uint32_t none = std::uint32_t(-1); // it has gone

        // The first `both` rows stay where they are.
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

    // Of the samples, ascending, at least one.
    virtual const std::vector<double>& times() const = 0;
    virtual std::size_t columns() const = 0;
    // `columns`: which ones are asked for.
    virtual Sample sample(std::size_t k, const std::vector<bool>& columns) const = 0;
    // Of the rows of sample k, which is not the last.
    virtual Successors successors(std::size_t k) const = 0;
    virtual int most() const = 0; // elements at one time
    // The column that has the velocity of another, in its units a second.
    virtual std::optional<std::size_t> velocity_of(std::size_t column) const = 0;

    // Of what the samples say, not of where they are kept.
    virtual void add_column(base::Fingerprint& print, std::size_t column) const = 0;
    virtual void add_rows(base::Fingerprint& print) const = 0;

    // For people: where sample k comes from ("p.0007.ply: PLY, ascii; 1 of 90 files"), and what its
    // columns are called there.
    virtual std::string origin(std::size_t k) const = 0;
    virtual std::vector<std::string> names() const = 0;

protected:
    SampleSource() = default;
    SampleSource(const SampleSource&) = default;
    SampleSource& operator=(const SampleSource&) = default;
};

// Of the rows of one sample, by the ids of its elements and of those of the next. Ids are unique
// within each.
std::vector<std::uint32_t> match(std::span<const std::int64_t> here,
                                 std::span<const std::int64_t> there);

// The first row whose id one before it has already, and that one.
struct Twins {
    std::size_t first = 0, second = 0;
};
std::optional<Twins> find_twins(std::span<const std::int64_t> ids);

} // namespace isomotion::animation

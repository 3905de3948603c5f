// Samples kept in memory, one after the other.
#pragma once

#include <string>

#include "animation/sample_source.h"

namespace isomotion::animation {

// The table by rows; each row is one element at one time.
struct SampleRows {
    std::vector<double> times;               // of the samples, ascending, at least one
    std::vector<std::size_t> begin;          // first row of each sample, and the end of the last
    std::vector<std::vector<double>> values; // [column][row]
    // Identify elements, unique within a sample. Without ids, the k-th element of a sample is the
    // k-th of the next.
    std::vector<std::int64_t> ids;
    std::vector<std::optional<std::size_t>> velocities{}; // of each column; may be empty
    std::string origin{};                                 // for people
    std::vector<std::string> names{};                     // of the columns, for people
    std::filesystem::path file{};                         // which holds them; empty: none
};

class SampleTable final : public SampleSource {
public:
    explicit SampleTable(SampleRows rows);

    const std::vector<double>& times() const override { return rows_.times; }
    std::size_t columns() const override { return rows_.values.size(); }
    Sample sample(std::size_t k, const std::vector<bool>& columns) const override;
    Successors successors(std::size_t k) const override;
    int most() const override;
    std::optional<std::size_t> velocity_of(std::size_t column) const override;
    void add_column(base::Fingerprint& print, std::size_t column) const override;
    void add_rows(base::Fingerprint& print) const override;
    std::string origin(std::size_t) const override { return rows_.origin; }
    std::vector<std::string> names() const override { return rows_.names; }
    std::vector<std::filesystem::path> files() const override {
        if (rows_.file.empty()) return {};
        return {rows_.file};
    }

private:
    std::size_t count(std::size_t k) const { return rows_.begin[k + 1] - rows_.begin[k]; }

    SampleRows rows_;
    std::vector<std::uint32_t> successors_; // for each row, if there are ids
};

} // namespace isomotion::animation

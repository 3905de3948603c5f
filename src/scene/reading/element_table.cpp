#include "scene/reading/element_table.h"
#include "base/printable.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "base/printable.h"
#include "scene/error.h"
#include "scene/limits.h"
#include "scene/particles/chemical_elements.h"
#include "scene/particles/file_frames.h"
#include "scene/particles/read_particles.h"
#include "scene/reading/file_part.h"

namespace isomotion::scene {
namespace {

// Whether a column of the format may tell the time of a row.
bool tells_times(std::string_view format) {
    return format == "CSV" || format.starts_with("NPY") || format == "XYZ" || format == "PDB";
}

// Fields that may be an element's, not the file's.
std::set<std::string> fields_of_elements(std::string_view format) {
    if (!format.starts_with("XYZ") && !format.starts_with("PDB")) return {};
    return {element_columns.begin(), element_columns.end()};
}

// Makes samples of the rows of one file.
class RowsInTime {
public:
    RowsInTime(const Part& part, const animation::Timeline& timeline, SharedTable& file)
        : options_(*part.options)
        , timeline_(timeline)
        , choice_(part.choice)
        , columns_(part.columns)
        , file_(file)
        , table_(file.table())
        , place_column_(choice_.from.empty() ? 0 : choice_.from.front()) {}

    ElementTable read(Interpolation rule) {
        ElementTable result{nullptr, choice_.fields, fields_of_elements(table_.format), here(0),
                            here(table_.count - 1)};
        split_by_time();
        rows_.file = options_.file;
        rows_.origin = fmt::format("{}: {}", options_.file.string(), table_.format);
        if (rows_.times.size() > 1) rows_.origin += fmt::format(", {} times", rows_.times.size());
        take_columns();
        result.samples = std::make_shared<const animation::ElementSamples>(std::move(rows_), rule);
        return result;
    }

private:
    std::string here(std::size_t row) const { return file_.place_of(row, place_column_); }
    [[noreturn]] void fail(std::size_t row, const std::string& column,
                           const std::string& message) const {
        throw SceneError(
            fmt::format("{}: {}{}", here(row), column.empty() ? "" : column + ": ", message));
    }
    // Another row of the same file.
    std::string other(std::size_t row) const {
        return table_.lines.empty() ? fmt::format("particle {}", row + 1)
                                    : fmt::format("line {}", table_.lines[row]);
    }

    void split_by_time() {
        const auto& column = choice_.time_column;
        if (choice_.time == ColumnChoice::Time::none || !column) {
            rows_.times = {0};
            rows_.begin = {0, table_.count};
            if (table_.count > std::size_t(options_.most)) too_many(std::size_t(options_.most), 0);
            return;
        }
        const std::vector<double> times = file_.numbers(*column);
        auto bare = table_.bare.begin();
        std::size_t kept = 0;
        for (std::size_t row = 0; row < table_.count; ++row) {
            begin_row(row, table_.columns[*column].name, times[row], kept);
            if (bare != table_.bare.end() && *bare == row) {
                ++bare;
                if (sample_row_ != row) {
                    fail(row, "",
                         fmt::format("the time alone says that there are no elements then, but {} "
                                     "is of the same time",
                                     other(sample_row_)));
                }
                sample_is_empty_ = true;
                continue;
            }
            if (sample_is_empty_) {
                fail(row, "",
                     fmt::format("{} says that there are no elements at this time",
                                 other(sample_row_)));
            }
            ++kept;
            if (kept - rows_.begin.back() > std::size_t(options_.most))
                too_many(row, rows_.begin.back());
        }
        rows_.begin.push_back(kept);
    }

    [[noreturn]] void too_many(std::size_t row, std::size_t) const {
        fail(row, "",
             fmt::format("is element {} of its time; the array's count allows {}",
                         options_.most + 1, options_.most));
    }

    // `name`: of the column with the time.
    void begin_row(std::size_t row, const std::string& name, double now, std::size_t kept) {
        if (choice_.time == ColumnChoice::Time::seconds) {
            if (!rows_.times.empty() && now == rows_.times.back()) return;
            if (!rows_.times.empty() && now < rows_.times.back()) {
                fail(row, name,
                     fmt::format("{} comes after {}; rows must be in the order of time", now,
                                 rows_.times.back()));
            }
            return begin_sample(row, now, kept);
        }
        if (now != std::floor(now))
            fail(row, name, fmt::format("'{}' must be a whole number", now));
        if (std::abs(now) > limits::frames) {
            fail(row, name,
                 fmt::format("frames are numbered up to {}, not {}", limits::frames, now));
        }
        const auto frame = std::int64_t(now);
        if (frame == last_frame_) return;
        if (last_frame_) check_step(row, name, *last_frame_, frame);
        last_frame_ = frame;
        begin_sample(row, timeline_.time(frame), kept);
    }

    void check_step(std::size_t row, const std::string& name, std::int64_t last, std::int64_t now) {
        const std::int64_t step = now - last;
        if (step < 0) {
            fail(row, name,
                 fmt::format("{} comes after {}; rows must be in the order of time", now, last));
        }
        if (stride_ == 0) stride_ = step;
        if (step > stride_) {
            fail(row, name,
                 fmt::format("frame {} follows {}: frame {} is missing; a frame without "
                             "elements is a line with its number alone",
                             now, last, last + stride_));
        }
        if (step < stride_) {
            fail(row, name,
                 fmt::format("frame {} follows {}, but the frames before are {} apart; "
                             "uneven times go into a column `t`",
                             now, last, stride_));
        }
    }

    void begin_sample(std::size_t row, double time, std::size_t kept) {
        rows_.times.push_back(time);
        rows_.begin.push_back(kept);
        sample_row_ = row;
        sample_is_empty_ = false;
    }

    template<class T> void leave_out_bare(std::vector<T>& values) const {
        if (table_.bare.empty()) return;
        auto bare = table_.bare.begin();
        std::size_t kept = 0;
        for (std::size_t row = 0; row < values.size(); ++row) {
            if (bare != table_.bare.end() && *bare == row) {
                ++bare;
            } else {
                values[kept++] = values[row];
            }
        }
        values.resize(kept);
    }

    void take_columns() {
        if (choice_.id_column) take_ids(*choice_.id_column);
        for (const std::size_t column : columns_.from) {
            rows_.names.push_back(table_.columns[column].name);
            rows_.values.push_back(file_.numbers(column));
            leave_out_bare(rows_.values.back());
        }
        rows_.velocities = columns_.velocities;
    }

    void take_ids(std::size_t column) {
        rows_.ids = file_.whole_numbers(column);
        leave_out_bare(rows_.ids);
        for (std::size_t k = 0; k + 1 < rows_.begin.size(); ++k) {
            const auto ids =
                std::span(rows_.ids).subspan(rows_.begin[k], rows_.begin[k + 1] - rows_.begin[k]);
            const auto twins = animation::find_twins(ids);
            if (!twins) continue;
            fail(with_bare(rows_.begin[k] + twins->second), "id",
                 fmt::format("{} is in {} already, at the same time", ids[twins->first],
                             other(with_bare(rows_.begin[k] + twins->first))));
        }
    }

    // The row of the file that is the k-th which isn't bare.
    std::size_t with_bare(std::size_t k) const {
        for (const std::size_t bare : table_.bare) {
            if (bare <= k) ++k;
        }
        return k;
    }

    const TableOptions& options_;
    const animation::Timeline& timeline_;
    const ColumnChoice& choice_;
    const SampledColumns& columns_;
    SharedTable& file_;
    const ParticleTable& table_;
    std::size_t place_column_;

    std::optional<std::int64_t> last_frame_;
    std::int64_t stride_ = 0;
    std::size_t sample_row_ = 0; // where the sample begins
    bool sample_is_empty_ = false;
    animation::SampleRows rows_;
};

// One file, read once for all that arrays ask of it.
std::vector<ElementTable> read_rows_in_time(std::span<const TableOptions> options,
                                            const animation::Timeline& timeline,
                                            TableBudget& budget) {
    std::vector<Part> parts;
    ParticleRequest request;
    request.file = options.front().file;
    request.within = options.front().within;
    Wanted wanted;
    request.choose = [&](const std::string& format, const std::vector<std::string>& names) {
        wanted = {std::vector<bool>(names.size()), 0, budget.values, {}, 0};
        for (const TableOptions& asked : options) {
            const Part& part = parts.emplace_back(asked, names, tells_times(format));
            wanted.most = std::max(wanted.most, part.moves() ? std::size_t(limits::table_values)
                                                             : std::size_t(asked.most));
            wanted.time = part.choice.time_column;
            part.for_each_use([&](std::size_t column) {
                wanted.columns[column] = true;
                ++*wanted.kept;
            });
        }
        return wanted;
    };
    ReadParticles read = read_particles(request, budget.bytes);
    budget.bytes -= read.bytes;
    budget.values -= wanted.numbers(read.table.count);
    if (read.table.count == read.table.bare.size() && read.table.bare.empty()) {
        if (read.table.end_line > 0)
            fail_at_line(request, read.table.end_line, "holds no element below its header");
        fail_of_file(request, "holds no particle");
    }
    SharedTable file(std::move(read.table), request.file, parts);
    std::vector<ElementTable> tables;
    tables.reserve(parts.size());
    for (const Part& part : parts)
        tables.push_back(RowsInTime(part, timeline, file).read(part.rule));
    return tables;
}

// A file for each frame: only the first is read here.
ElementTable read_frames(const TableOptions& options, const animation::Timeline& timeline) {
    FrameFiles files;
    for (const auto& [frame, file] : options.frames) {
        files.files.push_back(file);
        files.times.push_back(timeline.time(frame));
    }
    files.most = std::size_t(options.most);
    files.within = options.within;
    if (options.counts_files) {
        files.most = 0;
        std::size_t left = limits::counted_bytes;
        for (const std::filesystem::path& file : files.files) {
            if (left == 0) {
                throw SceneError(fmt::format(
                    "{}: more than {} bytes of these files would be read to count their particles; "
                    "give the array a count, the most that a file holds",
                    base::printable_line(file.string()), limits::counted_bytes));
            }
            const std::size_t count =
                count_particles(file, options.within, limits::table_bytes, left);
            if (count > std::size_t(options.most)) {
                throw SceneError(fmt::format("{}: says that it holds {} particles; there may be {}",
                                             file.string(), count, options.most));
            }
            files.most = std::max(files.most, count);
        }
    }
    ElementTable result;
    Interpolation rule = Interpolation::linear;
    ParticleRequest request;
    request.file = files.files.front();
    request.within = options.within;
    request.choose = [&](const std::string& format, const std::vector<std::string>& names) {
        if ((format == "XYZ" || format == "PDB") && find_column(names, "frame")) {
            throw NamedColumn{"frame",
                              "the file holds several times, and so does `file`, which names "
                              "one file for each frame; name this one alone"};
        }
        const ColumnChoice choice = choose_columns(names, options.columns, false);
        SampledColumns columns = sampled_columns(choice, names, options.interpolation);
        rule = rule_of(options.interpolation, columns);
        // Columns that no field reads are there to be shown.
        for (std::size_t k = 0; k < names.size(); ++k) {
            if (std::ranges::find(columns.from, k) == columns.from.end()) columns.from.push_back(k);
        }
        columns.velocities.resize(columns.from.size());
        result.fields = choice.fields;
        result.of_elements = fields_of_elements(format);
        for (const std::size_t column : columns.from) files.columns.push_back(names[column]);
        files.velocities = columns.velocities;
        return Wanted{std::vector<bool>(names.size()), files.most, limits::table_values};
    };
    read_particles(request, limits::table_bytes);
    if (files.columns.empty()) {
        fail_of_file(request,
                     "holds no particle, and no name of a column; the first file must tell "
                     "what columns there are");
    }
    result.first = files.files.front().string();
    result.last = files.files.back().string();
    result.samples = std::make_shared<const animation::ElementSamples>(
        std::make_shared<const FileFrames>(std::move(files)), rule);
    return result;
}

} // namespace

std::vector<ElementTable> read_element_tables(std::span<const TableOptions> options,
                                              const animation::Timeline& timeline,
                                              TableBudget& budget) {
    if (options.front().frames.empty()) return read_rows_in_time(options, timeline, budget);
    std::vector<ElementTable> tables;
    for (const TableOptions& asked : options) tables.push_back(read_frames(asked, timeline));
    return tables;
}

} // namespace isomotion::scene

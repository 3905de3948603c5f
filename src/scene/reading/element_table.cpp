#include "scene/reading/element_table.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

#include <fmt/format.h>

#include "base/file_text.h"
#include "base/nearest_name.h"
#include "formula/graph/vocabulary.h"
#include "scene/error.h"
#include "scene/limits.h"

namespace isomotion::scene {
namespace {

std::string_view trimmed(std::string_view text) {
    constexpr std::string_view blank = " \t\r";
    const auto begin = text.find_first_not_of(blank);
    if (begin == text.npos) return {};
    return text.substr(begin, text.find_last_not_of(blank) - begin + 1);
}

// The cells of a line. Quoted ones may hold commas; a quote in them is doubled.
std::vector<std::string> quoted_cells(std::string_view line) {
    std::vector<std::string> cells(1);
    bool quoted = false;
    for (std::size_t k = 0; k < line.size(); ++k) {
        if (line[k] == '"') {
            const bool doubled = quoted && k + 1 < line.size() && line[k + 1] == '"';
            if (doubled) cells.back() += line[k++];
            if (!doubled) quoted = !quoted;
        } else if (line[k] == ',' && !quoted) {
            cells.emplace_back();
        } else {
            cells.back() += line[k];
        }
    }
    for (std::string& cell : cells) cell = trimmed(cell);
    return cells;
}

std::string text_of(const std::filesystem::path& file, TableBudget& budget) {
    std::error_code unknown;
    if (const auto size = std::filesystem::file_size(file, unknown);
        !unknown && size > budget.bytes)
        throw SceneError(fmt::format("{}: has {} bytes; {} are left of the {} of all tables that "
                                     "arrays of a scene name, with each name counted whose columns "
                                     "differ",
                                     file.string(), size, budget.bytes, limits::table_bytes));
    std::string text = base::file_text(file, budget.bytes);
    budget.bytes -= text.size();
    return text;
}

class Reader {
public:
    Reader(const TableOptions& options, const animation::Timeline& timeline, TableBudget& budget)
        : options_(options)
        , timeline_(timeline)
        , text_(text_of(options.file, budget)) {}

    ElementTable read(TableBudget& budget) {
        read_header();
        take_values_off(budget);
        ElementTable table;
        while (const auto line = next_line()) {
            if (table.first_line == 0) table.first_line = line_;
            table.last_line = line_;
            read_row(*line);
        }
        if (rows_.times.empty()) fail("", "holds no element below its header");
        rows_.begin.push_back(row_count_);
        table.fields = fields_;
        table.samples =
            std::make_shared<animation::ElementSamples>(std::move(rows_), options_.interpolation);
        return table;
    }

private:
    enum class Time { none, frame, seconds };

    [[noreturn]] void fail(const std::string& column, const std::string& message) const {
        throw SceneError(fmt::format("{}:{}: {}{}", options_.file.string(), line_,
                                     column.empty() ? "" : column + ": ", message));
    }

    // The next line that is neither blank nor a comment.
    std::optional<std::string_view> next_line() {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            std::string_view line = std::string_view(text_).substr(at_, end - at_);
            at_ = std::min(end + 1, text_.size()); // the last line may have no end
            if (++line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
            line = trimmed(line);
            if (!line.empty() && line.front() != '#') return line;
        }
        return std::nullopt;
    }

    // At most a row a line.
    void take_values_off(TableBudget& budget) const {
        const bool ends = text_.empty() || text_.back() == '\n';
        const auto rows =
            std::ranges::count(text_.begin() + std::ptrdiff_t(at_), text_.end(), '\n') + !ends;
        const double values = double(fields_.size()) * double(rows);
        if (values > budget.values) {
            fail("", fmt::format("has {} columns and {} lines; all tables of a scene hold at most "
                                 "{:.3g} numbers: leave columns out that the formula doesn't read",
                                 fields_.size(), rows, limits::table_values));
        }
        budget.values -= values;
    }

    void read_header() {
        const auto line = next_line();
        if (!line) {
            line_ = std::max(line_, 1);
            fail("", "is empty; it needs a line of column names, then one element a line");
        }
        names_ = quoted_cells(*line);
        if (names_.size() > std::size_t(limits::fields)) {
            fail("", fmt::format("names {} columns; at most {} are read", names_.size(),
                                 limits::fields));
        }
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (std::find(names_.begin(), names_.begin() + std::ptrdiff_t(k), names_[k]) !=
                names_.begin() + std::ptrdiff_t(k)) {
                fail(names_[k], "two columns have this name");
            }
        }
        const auto frame = column("frame"), seconds = column("t");
        if (frame && seconds) {
            fail("t", "the file has a column `frame` already; one of the two tells the time");
        }
        time_ = frame ? Time::frame : seconds ? Time::seconds : Time::none;
        time_column_ = frame ? frame : seconds;
        id_column_ = column("id");
        choose_fields();
    }

    std::optional<std::size_t> column(const std::string& name) const {
        const auto it = std::find(names_.begin(), names_.end(), name);
        if (it == names_.end()) return std::nullopt;
        return std::size_t(it - names_.begin());
    }

    void choose_fields() {
        std::vector<bool> taken(names_.size(), false);
        for (const auto& [field, name] : options_.columns) {
            const auto from = column(name);
            if (!from) {
                const std::string near = base::nearest_name(name, names_);
                fail(name, near.empty() ? fmt::format("there is no such column; the file has {}",
                                                      fmt::join(names_, ", "))
                                        : fmt::format("there is no such column; did you mean "
                                                      "'{}'?",
                                                      near));
            }
            taken[*from] = true;
            fields_.push_back(field);
            from_.push_back(*from);
        }
        for (std::size_t k = 0; k < names_.size(); ++k) {
            const std::string& name = names_[k];
            const bool spoken = formula::is_identifier(name) && !formula::is_reserved(name) &&
                                name != "t" && name != "i" && name != "n" && name != "frame" &&
                                name != "id";
            if (taken[k] || !spoken || options_.columns.count(name)) continue;
            fields_.push_back(name);
            from_.push_back(k);
        }
        rows_.values.resize(fields_.size());
    }

    double number(std::size_t column) const {
        const std::string_view cell = cells_[column];
        if (cell.empty()) fail(names_[column], "the cell is empty; it needs a number");
        double value = 0;
        // from_chars knows no leading plus.
        const bool plus = cell.front() == '+' && !cell.starts_with("+-");
        const char* begin = cell.data() + (plus ? 1 : 0);
        const auto [end, error] = std::from_chars(begin, cell.data() + cell.size(), value);
        if (error == std::errc::result_out_of_range) {
            fail(names_[column], fmt::format("'{}' is beyond the range of numbers", cell));
        }
        if (error != std::errc() || end != cell.data() + cell.size()) {
            fail(names_[column], fmt::format("'{}' is not a number", cell));
        }
        if (!std::isfinite(value)) {
            fail(names_[column], fmt::format("'{}' is not a finite number", cell));
        }
        return value;
    }

    std::int64_t whole_number(std::size_t column) const {
        const double value = number(column);
        if (value != std::floor(value) || std::abs(value) > 0x1p53) {
            fail(names_[column], fmt::format("'{}' must be a whole number", cells_[column]));
        }
        return std::int64_t(value);
    }

    void split(std::string_view line) {
        cells_.clear();
        const auto cells = std::size_t(std::ranges::count(line, ',')) + 1;
        if (cells != names_.size()) {
            fail("",
                 fmt::format("has {} cells; the header names {} columns", cells, names_.size()));
        }
        for (std::size_t begin = 0; begin <= line.size();) {
            const std::size_t end = std::min(line.find(',', begin), line.size());
            cells_.push_back(trimmed(line.substr(begin, end - begin)));
            begin = end + 1;
        }
    }

    void read_row(std::string_view line) {
        split(line);
        if (time_ == Time::none) {
            if (rows_.times.empty()) begin_sample(0);
        } else {
            read_time();
            if (says_nothing_but_the_time()) {
                if (sample_line_ != line_) {
                    fail("", fmt::format("the time alone says that there are no elements then, but "
                                         "line {} is of the same time",
                                         sample_line_));
                }
                sample_is_empty_ = true;
                return;
            }
            if (sample_is_empty_) {
                fail("", fmt::format("line {} says that there are no elements at this time",
                                     sample_line_));
            }
        }
        if (id_column_) read_id();
        for (std::size_t f = 0; f < fields_.size(); ++f) {
            rows_.values[f].push_back(number(from_[f]));
        }
        ++row_count_;
        if (row_count_ - rows_.begin.back() > std::size_t(options_.most)) {
            fail("", fmt::format("is element {} of its time; the array's count allows {}",
                                 row_count_ - rows_.begin.back(), options_.most));
        }
    }

    bool says_nothing_but_the_time() const {
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            if (k != *time_column_ && !cells_[k].empty()) return false;
        }
        return cells_.size() > 1;
    }

    void begin_sample(double time) {
        rows_.times.push_back(time);
        rows_.begin.push_back(row_count_);
        line_of_id_.clear();
        sample_line_ = line_;
        sample_is_empty_ = false;
    }

    void read_time() {
        const std::string& name = names_[*time_column_];
        if (time_ == Time::seconds) {
            const double now = number(*time_column_);
            if (!rows_.times.empty() && now == rows_.times.back()) return;
            if (!rows_.times.empty() && now < rows_.times.back()) {
                fail(name, fmt::format("{} comes after {}; rows must be in the order of time", now,
                                       rows_.times.back()));
            }
            begin_sample(now);
            return;
        }
        const std::int64_t now = whole_number(*time_column_);
        if (std::abs(now) > limits::frames) {
            fail(name, fmt::format("frames are numbered up to {}, not {}", limits::frames, now));
        }
        if (last_frame_ && now == *last_frame_) return;
        if (last_frame_) {
            const std::int64_t step = now - *last_frame_;
            if (step < 0) {
                fail(name, fmt::format("{} comes after {}; rows must be in the order of time", now,
                                       *last_frame_));
            }
            if (stride_ == 0) stride_ = step;
            if (step > stride_) {
                fail(name, fmt::format("frame {} follows {}: frame {} is missing; a frame without "
                                       "elements is a line with its number alone",
                                       now, *last_frame_, *last_frame_ + stride_));
            }
            if (step < stride_) {
                fail(name, fmt::format("frame {} follows {}, but the frames before are {} apart; "
                                       "uneven times go into a column `t`",
                                       now, *last_frame_, stride_));
            }
        }
        last_frame_ = now;
        begin_sample(timeline_.time(now));
    }

    void read_id() {
        const std::int64_t id = whole_number(*id_column_);
        const auto [it, is_new] = line_of_id_.emplace(id, line_);
        if (!is_new) {
            fail("id", fmt::format("{} is in line {} already, at the same time", id, it->second));
        }
        rows_.ids.push_back(id);
    }

    const TableOptions& options_;
    const animation::Timeline& timeline_;
    std::string text_;
    std::size_t at_ = 0;
    int line_ = 0;

    std::vector<std::string> names_;
    Time time_ = Time::none;
    std::optional<std::size_t> time_column_, id_column_;
    std::vector<std::string> fields_;
    std::vector<std::size_t> from_; // the column of each field

    std::vector<std::string_view> cells_; // of the line being read
    std::optional<std::int64_t> last_frame_;
    std::int64_t stride_ = 0;
    int sample_line_ = 0; // where the sample begins
    bool sample_is_empty_ = false;
    std::unordered_map<std::int64_t, int> line_of_id_;
    std::size_t row_count_ = 0;
    animation::ElementSamples::Rows rows_;
};

} // namespace

ElementTable read_element_table(const TableOptions& options, const animation::Timeline& timeline,
                                TableBudget& budget) {
    return Reader(options, timeline, budget).read(budget);
}

} // namespace isomotion::scene

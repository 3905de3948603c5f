#include <algorithm>

#include <fmt/format.h>

#include "scene/error.h"
#include "scene/limits.h"
#include "scene/particles/formats.h"
#include "scene/particles/words.h"

namespace isomotion::scene {
namespace {

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

class CsvReader {
public:
    CsvReader(const ParticleRequest& request, std::string_view text)
        : request_(request)
        , text_(text) {}

    void read(ParticleTable& table) {
        read_header(table);
        if (request_.count_alone) {
            while (next_line()) ++table.count;
            return;
        }
        std::vector<std::vector<double>> values(names_.size());
        while (const auto line = next_line()) {
            split(*line);
            if (says_nothing_but_the_time()) table.bare.push_back(table.lines.size());
            const bool is_bare = !table.bare.empty() && table.bare.back() == table.lines.size();
            for (std::size_t k = 0; k < names_.size(); ++k) {
                if (!wanted_.columns[k]) continue;
                values[k].push_back(is_bare && k != *wanted_.time ? 0 : number(k));
            }
            table.lines.push_back(line_);
        }
        table.count = table.lines.size();
        table.end_line = line_;
        for (std::size_t k = 0; k < names_.size(); ++k)
            table.columns.push_back({names_[k], std::move(values[k])});
    }

private:
    [[noreturn]] void fail(const std::string& column, const std::string& message) const {
        fail_at_line(request_, line_,
                     fmt::format("{}{}", column.empty() ? "" : column + ": ", message));
    }

    // The next line that is neither blank nor a comment.
    std::optional<std::string_view> next_line() {
        while (at_ < text_.size()) {
            const std::size_t end = std::min(text_.find('\n', at_), text_.size());
            std::string_view line = text_.substr(at_, end - at_);
            at_ = std::min(end + 1, text_.size()); // the last line may have no end
            if (++line_ == 1 && line.starts_with("\xEF\xBB\xBF")) line.remove_prefix(3);
            line = trimmed(line);
            if (!line.empty() && line.front() != '#') return line;
        }
        return std::nullopt;
    }

    void read_header(const ParticleTable& table) {
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
        if (request_.count_alone) return;
        try {
            wanted_ = request_.choose(table.format, names_);
        } catch (const NamedColumn& wrong) {
            fail(wrong.column, wrong.message);
        }
        // At most a row a line.
        const bool ends = text_.empty() || text_.back() == '\n';
        const auto rows =
            std::ranges::count(text_.begin() + std::ptrdiff_t(at_), text_.end(), '\n') + !ends;
        if (const double numbers = wanted_.numbers(std::size_t(rows)); numbers > wanted_.values) {
            fail("", fmt::format("has {} lines, and {:.3g} numbers of them are kept; all tables of "
                                 "a scene hold at most {:.3g}: leave columns out that the formula "
                                 "doesn't read",
                                 rows, numbers, limits::table_values));
        }
    }

    double number(std::size_t column) const {
        const std::string_view cell = cells_[column];
        if (cell.empty()) fail(names_[column], "the cell is empty; it needs a number");
        const Number number = number_of(cell);
        if (!number.wrong.empty()) fail(names_[column], number.wrong);
        return number.value;
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

    bool says_nothing_but_the_time() const {
        if (!wanted_.time) return false;
        for (std::size_t k = 0; k < cells_.size(); ++k) {
            if (k != *wanted_.time && !cells_[k].empty()) return false;
        }
        return cells_.size() > 1;
    }

    const ParticleRequest& request_;
    std::string_view text_;
    std::size_t at_ = 0;
    int line_ = 0;
    std::vector<std::string> names_;
    Wanted wanted_;
    std::vector<std::string_view> cells_; // of the line being read
};

} // namespace

ParticleTable read_csv(const Bytes& bytes, const ParticleRequest& request) {
    ParticleTable table;
    table.format = "CSV";
    CsvReader(request, *bytes).read(table);
    return table;
}

} // namespace isomotion::scene

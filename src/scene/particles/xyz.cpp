#include <algorithm>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/formats.h"
#include "scene/particles/words.h"

namespace isomotion::scene {
namespace {

std::vector<std::string_view> cells_of(std::string_view line) {
    std::vector<std::string_view> cells;
    for (std::size_t at = 0; cells.size() <= std::size_t(limits::fields);) {
        at = line.find_first_not_of(" \t\r", at);
        if (at == line.npos) break;
        const std::size_t end = std::min(line.find_first_of(" \t\r", at), line.size());
        cells.push_back(line.substr(at, end - at));
        at = end;
    }
    return cells;
}

bool is_number(std::string_view cell) { return number_of(cell).wrong.empty(); }

// Rows of as many cells as the first has; what is left out before the numbers is a symbol.
class RowReader {
public:
    RowReader(const ParticleRequest& request, Words& words, ParticleTable& table)
        : request_(request)
        , words_(words)
        , table_(table) {}

    void begin(const std::vector<std::string_view>& cells, bool has_symbol, std::size_t count) {
        symbols_ = has_symbol ? 1 : 0;
        if (cells.size() <= symbols_) words_.fail("has no numbers");
        names_ = names_without_names(cells.size() - symbols_);
        wanted_ = wanted_of(request_, table_.format, names_, count);
        values_.resize(names_.size());
    }
    bool has_begun() const { return !names_.empty(); }

    void add(const std::vector<std::string_view>& cells) {
        if (cells.size() != names_.size() + symbols_) {
            words_.fail(fmt::format("has {} words; the rows before have {}", cells.size(),
                                    names_.size() + symbols_));
        }
        table_.lines.push_back(words_.line());
        for (std::size_t k = 0; k < names_.size(); ++k) {
            if (wanted_.columns[k])
                values_[k].push_back(words_.number(cells[k + symbols_], names_[k]));
        }
    }

    void end() {
        table_.count = table_.lines.size();
        for (std::size_t k = 0; k < names_.size(); ++k)
            table_.columns.push_back({names_[k], std::move(values_[k])});
    }

private:
    const ParticleRequest& request_;
    Words& words_;
    ParticleTable& table_;
    std::size_t symbols_ = 0;
    std::vector<std::string> names_;
    Wanted wanted_;
    std::vector<std::vector<double>> values_;
};

// The next line that says something; a comment begins with #.
std::optional<std::string_view> next_row(Words& words) {
    for (;;) {
        const auto line = words.rest_of_line();
        if (!line) return std::nullopt;
        if (!line->empty() && line->front() != '#') return line;
    }
}

} // namespace

ParticleTable read_xyz(const Bytes& bytes, const ParticleRequest& request) {
    Words words(request, *bytes);
    ParticleTable table;
    table.format = "XYZ";
    table.count = words.count("the number of particles in the first line");
    if (const auto rest = words.rest_of_line(); rest && !rest->empty())
        words.fail("the first line has more than the number of particles");
    if (request.count_alone) return table;
    words.rest_of_line(); // a comment
    const std::size_t count = table.count;
    RowReader rows(request, words, table);
    for (std::size_t row = 0; row < count; ++row) {
        const auto line = words.rest_of_line();
        if (!line || line->empty()) {
            words.fail(fmt::format("the first line says that there are {} particles; {} are here",
                                   count, row));
        }
        const auto cells = cells_of(*line);
        // An element's number may stand for its symbol.
        if (row == 0) rows.begin(cells, !is_number(cells[0]) || cells.size() == 4, count);
        rows.add(cells);
    }
    if (next_row(words)) {
        words.fail(fmt::format("follows the {} particles of the first line; a file holds those of "
                               "one time",
                               count));
    }
    rows.end();
    return table;
}

ParticleTable read_rows(const Bytes& bytes, const ParticleRequest& request) {
    Words words(request, *bytes);
    ParticleTable table;
    table.format = "rows of numbers";
    if (bytes->empty()) fail_of_file(request, "is empty");
    // At most a row a line.
    const bool ends = bytes->empty() || bytes->back() == '\n';
    const auto lines = std::size_t(std::ranges::count(*bytes, '\n')) + (ends ? 0 : 1);
    if (request.count_alone) {
        while (next_row(words)) ++table.count;
        return table;
    }
    RowReader rows(request, words, table);
    std::size_t blank = 0; // lines that are no rows, before the first
    for (;;) {
        const auto line = next_row(words);
        if (!line) break;
        const auto cells = cells_of(*line);
        if (!rows.has_begun()) {
            blank = std::size_t(words.line()) - 1;
            rows.begin(cells, !is_number(cells[0]), lines - std::min(lines, blank));
        }
        rows.add(cells);
    }
    rows.end();
    return table;
}

} // namespace isomotion::scene

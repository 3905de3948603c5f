#include <algorithm>
#include <charconv>

#include <fmt/format.h>

#include "scene/particles/atom_rows.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/chemical_elements.h"
#include "scene/particles/formats.h"

namespace isomotion::scene {
namespace {

bool is_number(std::string_view cell) { return number_of(cell).wrong.empty(); }

// The next line that says something; empty at the end of the text. A comment begins with #.
std::string_view next_row(Words& words) {
    for (;;) {
        const auto line = words.rest_of_line();
        if (!line) return {};
        if (!line->empty() && line->front() != '#') return *line;
    }
}

// A count alone in its line.
std::optional<std::size_t> count_in(std::string_view line) {
    std::size_t count = 0;
    const char* end = line.data() + line.size();
    const auto [at, error] = std::from_chars(line.data(), end, count);
    return error == std::errc() && at == end && !line.empty() ? std::optional(count) : std::nullopt;
}

// How many frames a text has, and how many particles all of them say that they have.
struct Extent {
    int frames = 0;
    std::size_t particles = 0;
    bool has_elements = false; // a row begins with the symbol of one
};

Extent extent_of(const ParticleRequest& request, std::string_view text) {
    Words words(request, text);
    Extent found;
    for (;;) {
        const auto count = count_in(next_row(words));
        if (!count) break;
        ++found.frames;
        found.particles += std::min(*count, text.size());
        words.rest_of_line(); // a comment
        for (std::size_t row = 0; row < *count; ++row) {
            const auto line = words.rest_of_line();
            if (!line) break;
            const std::string_view first = line->substr(0, line->find_first_of(" \t"));
            found.has_elements = found.has_elements || atomic_number(first) > 0;
        }
    }
    return found;
}

// The columns that the comment of an extended XYZ states, "Properties=species:S:1:pos:R:3"; none if
// it states none.
// `many`: the file has several frames, whose times are those of the scene's frames.
std::optional<RowLayout> stated_layout(std::string_view comment, bool many) {
    constexpr std::string_view key = "Properties=";
    const std::size_t begin = comment.find(key);
    if (begin == comment.npos) return std::nullopt;
    std::string_view text = comment.substr(begin + key.size());
    if (text.starts_with('"')) text.remove_prefix(1);
    text = text.substr(0, std::min(text.find_first_of("\" \t\r"), text.size()));
    RowLayout layout;
    const auto next = [&] {
        const std::size_t end = std::min(text.find(':'), text.size());
        const std::string_view part = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        return part;
    };
    while (!text.empty()) {
        const std::string_view name = next(), type = next();
        const std::size_t count = count_in(next()).value_or(0);
        if (name.empty() || type.size() != 1 || count == 0 || count > 100) return std::nullopt;
        const bool is_time = many && (name == "frame" || name == "t" || name == "time");
        if ((type == "R" || type == "I") && !is_time) {
            add_names(layout.names, name == "velo" ? "velocity" : name, count);
            for (std::size_t k = 0; k < count; ++k) layout.cells.push_back(layout.width + k);
        }
        if (name == "species" || name == "element" || name == "Z") layout.element = layout.width;
        layout.width += count;
    }
    if (layout.names.empty()) return std::nullopt;
    return layout;
}

// A symbol before the numbers, or an element's number before three, or before what else may follow
// a place.
RowLayout layout_of(const Words& words, const std::vector<std::string_view>& cells,
                    bool has_elements) {
    const bool may_be_number = cells.size() == 5 || cells.size() == 7 || cells.size() == 8;
    const bool has_symbol =
        !is_number(cells[0]) || cells.size() == 4 || (may_be_number && atomic_number(cells[0]) > 0);
    if (has_symbol && cells.size() == 1) words.fail("has no numbers");
    RowLayout layout = layout_without_names(cells.size(), has_symbol ? 1 : 0);
    if (has_symbol && has_elements) layout.element = 0;
    return layout;
}

// Reads the rows of one time.
void read_frame(Words& words, AtomRows& rows, int frame, const Extent& extent) {
    const bool many = extent.frames > 1;
    const std::size_t count = count_in(next_row(words)).value_or(0);
    const std::string says = words.line() == 1 ? std::string("first line")
                                               : fmt::format("count in line {}", words.line());
    const auto comment = words.rest_of_line().value_or("");
    if (count == 0 && many) {
        if (!rows.has_begun())
            words.fail("the first frame has no particle; it must tell what columns there are");
        rows.add_none(frame);
    }
    for (std::size_t row = 0; row < count; ++row) {
        const auto next = words.rest_of_line();
        if (!next || next->empty()) {
            words.fail(fmt::format("the {} says that there are {} particles; {} are here", says,
                                   count, row));
        }
        const auto cells = cells_of(*next);
        if (!rows.has_begun()) {
            RowLayout layout =
                stated_layout(comment, many).value_or(layout_of(words, cells, extent.has_elements));
            layout.has_frames = many;
            rows.begin(std::move(layout), std::max(extent.particles, count));
        }
        rows.add(cells, frame);
    }
}

} // namespace

ParticleTable read_xyz(const Bytes& bytes, const ParticleRequest& request) {
    Words words(request, *bytes);
    ParticleTable table;
    table.format = "XYZ";
    table.count = words.count("the number of particles in the first line");
    if (!words.rest_of_line().value_or("").empty())
        words.fail("the first line has more than the number of particles");
    if (request.count_alone) return table;
    const Extent extent = extent_of(request, *bytes);
    Words all(request, *bytes);
    AtomRows rows(request, all, table);
    for (int frame = 1; frame == 1 || frame <= extent.frames; ++frame)
        read_frame(all, rows, frame, extent);
    if (!next_row(all).empty()) {
        all.fail(fmt::format("follows the {} particles that the file has so far; those of another "
                             "time begin with their count",
                             extent.particles));
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
        while (!next_row(words).empty()) ++table.count;
        return table;
    }
    AtomRows rows(request, words, table);
    for (;;) {
        const auto cells = cells_of(next_row(words));
        if (cells.empty()) break;
        if (!rows.has_begun()) {
            const bool has_symbol = !is_number(cells[0]);
            if (has_symbol && cells.size() == 1) words.fail("has no numbers");
            const auto before = std::size_t(words.line()) - 1; // lines that are no rows
            rows.begin(layout_without_names(cells.size(), has_symbol ? 1 : 0),
                       lines - std::min(lines, before));
        }
        rows.add(cells);
    }
    rows.end();
    return table;
}

} // namespace isomotion::scene

// Atoms of the Protein Data Bank's format, version 3.3: records of fixed columns.
#include <algorithm>
#include <map>

#include "scene/particles/atom_rows.h"
#include "scene/particles/chemical_elements.h"
#include "scene/particles/formats.h"

namespace isomotion::scene {
namespace {

// Columns are counted from 1, as the format's description does; what a short line lacks is empty.
std::string_view columns(std::string_view line, std::size_t first, std::size_t last) {
    if (line.size() < first) return {};
    return trimmed(line.substr(first - 1, last - first + 1));
}

bool is_atom(std::string_view line) {
    return line.starts_with("ATOM  ") || line.starts_with("HETATM");
}

// The atoms of a residue may be at several places, each with a letter. Those count that have the
// letter which the file names first in the residue.
class Places {
public:
    bool counts(std::string_view atom) {
        const char letter = atom.size() < 17 ? ' ' : atom[16];
        if (letter == ' ') return true;
        const std::string_view residue = atom.substr(21, 6); // chain, number, insertion
        return first_.try_emplace(residue, letter).first->second == letter;
    }
    void begin_model() { first_.clear(); }

private:
    std::map<std::string_view, char> first_;
};

// Older files leave the element out. The atom's name has its symbol right-justified in columns 13
// and 14, but for hydrogens of long names.
std::string_view element_of(std::string_view atom) {
    const std::string_view stated = columns(atom, 77, 78);
    const bool is_digit =
        !stated.empty() && '0' <= stated[0] && stated[0] <= '9'; // a line's number
    if (!is_digit && atomic_number(stated) > 0) return stated;
    const std::string_view two = columns(atom, 13, 14), name = columns(atom, 13, 16);
    const bool has_two_letters = atom.size() > 12 && atom[12] != ' ' && name.size() < 4;
    if (has_two_letters && atomic_number(two) > 0) return two;
    const auto letter = name.find_first_not_of("0123456789");
    return letter == name.npos ? name : name.substr(letter, 1);
}

// Numbers too long for their columns are stars.
std::string_view or_0(std::string_view cell) {
    return cell.empty() || cell.starts_with('*') ? "0" : cell;
}

class PdbReader {
public:
    PdbReader(const ParticleRequest& request, std::string_view text, ParticleTable& table)
        : request_(request)
        , text_(text)
        , table_(table) {}

    // Counts atoms and models.
    void count() {
        Places places;
        Words words(request_, text_);
        while (words.left() > 0) {
            const std::string_view line = words.line_as_it_is().value_or("");
            if (line.starts_with("MODEL ")) {
                ++models_;
                places.begin_model();
            }
            if (is_atom(line) && places.counts(line)) ++table_.count;
        }
    }

    void read() {
        count();
        if (table_.count == 0) fail_of_file(request_, "has no record ATOM or HETATM");
        Places places;
        Words words(request_, text_);
        AtomRows rows(request_, words, table_);
        rows.begin(layout(), table_.count);
        int model = 0, last = 0; // with an atom
        while (words.left() > 0) {
            const std::string_view line = words.line_as_it_is().value_or("");
            if (line.starts_with("MODEL ")) {
                if (model > last && last > 0) rows.add_none(model);
                ++model;
                places.begin_model();
            }
            if (!is_atom(line) || !places.counts(line)) continue;
            rows.add({element_of(line), columns(line, 31, 38), columns(line, 39, 46),
                      columns(line, 47, 54), or_0(columns(line, 55, 60)),
                      or_0(columns(line, 61, 66))},
                     std::max(model, 1));
            last = std::max(model, 1);
        }
        if (model > last) rows.add_none(model);
        rows.end();
    }

private:
    RowLayout layout() const {
        return {.width = 6,
                .names = {"x", "y", "z", "occupancy", "b_factor"},
                .cells = {1, 2, 3, 4, 5},
                .element = 0,
                .has_frames = models_ > 1};
    }

    const ParticleRequest& request_;
    std::string_view text_;
    ParticleTable& table_;
    int models_ = 0;
};

} // namespace

ParticleTable read_pdb(const Bytes& bytes, const ParticleRequest& request) {
    ParticleTable table;
    table.format = "PDB";
    PdbReader reader(request, *bytes, table);
    if (request.count_alone)
        reader.count();
    else
        reader.read();
    return table;
}

} // namespace isomotion::scene

#include <cstdlib>
#include <optional>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/formats.h"
#include "scene/particles/words.h"

namespace isomotion::scene {
namespace {

// Numbers of the points, as they lie in the file.
struct PointArray {
    std::string name;
    std::size_t components = 1;
    Scalar type = Scalar::f32;
    std::size_t at = 0; // their first byte, or before their first word
};

Scalar type_of(const Words& words, std::string_view name) {
    constexpr std::pair<std::string_view, Scalar> known[] = {{"unsigned_char", Scalar::u8},
                                                             {"char", Scalar::i8},
                                                             {"signed_char", Scalar::i8},
                                                             {"unsigned_short", Scalar::u16},
                                                             {"short", Scalar::i16},
                                                             {"unsigned_int", Scalar::u32},
                                                             {"int", Scalar::i32},
                                                             {"unsigned_long", Scalar::u64},
                                                             {"long", Scalar::i64},
                                                             {"float", Scalar::f32},
                                                             {"double", Scalar::f64},
                                                             {"vtktypeint64", Scalar::i64},
                                                             {"vtktypeuint64", Scalar::u64},
                                                             {"vtkIdType", Scalar::i32},
                                                             {"unsigned_long_long", Scalar::u64},
                                                             {"long_long", Scalar::i64}};
    for (const auto& [spelling, type] : known) {
        if (spelling == name) return type;
    }
    words.fail(fmt::format("the type is '{}'; char, short, int, long, unsigned or not, float and "
                           "double are read",
                           name.substr(0, 60)));
}

// Finds where the points and what belongs to them are.
class VtkReader {
public:
    VtkReader(const ParticleRequest& request, std::string_view text)
        : words_(request, text)
        , count_alone_(request.count_alone) {}

    void read() {
        const std::string_view first = words_.rest_of_line().value_or("");
        constexpr std::string_view version = "Version ";
        if (const auto at = first.find(version); at != first.npos)
            version_ = std::atoi(std::string(first.substr(at + version.size(), 4)).c_str());
        words_.rest_of_line(); // the title
        const std::string_view encoding = words_.need("ASCII or BINARY");
        if (encoding != "ASCII" && encoding != "BINARY")
            words_.fail(fmt::format("the third line must be ASCII or BINARY, not '{}'",
                                    encoding.substr(0, 60)));
        is_ascii = encoding == "ASCII";
        for (std::string_view key = words_.next(); !key.empty(); key = words_.next()) {
            part(key);
            if (count_alone_ && has_points_) return;
        }
        if (!has_points_) words_.fail("the file ends before POINTS");
    }

    bool is_ascii = true;
    std::size_t count = 0;
    std::vector<PointArray> arrays; // first the places

private:
    void part(std::string_view key) {
        if (key == "DATASET") {
            const std::string_view kind = words_.need("the kind of data set");
            if (kind != "POLYDATA" && kind != "UNSTRUCTURED_GRID") {
                words_.fail(fmt::format("the data set is '{}'; POLYDATA and UNSTRUCTURED_GRID are "
                                        "read",
                                        kind.substr(0, 60)));
            }
        } else if (key == "POINTS") {
            if (has_points_) words_.fail("has POINTS twice");
            count = tuples_ = words_.count("the number of points");
            has_points_ = of_points_ = true;
            if (!count_alone_) array("position", 3, words_.need("the type of the points"), count);
            of_points_ = false;
        } else if (key == "VERTICES" || key == "LINES" || key == "POLYGONS" ||
                   key == "TRIANGLE_STRIPS" || key == "CELLS") {
            cells();
        } else if (key == "CELL_TYPES") {
            array("", 1, "int", words_.count("the number of cells"));
        } else if (key == "POINT_DATA" || key == "CELL_DATA") {
            of_points_ = key == "POINT_DATA";
            tuples_ = words_.count(fmt::format("the number after {}", key));
            if (of_points_ && tuples_ != count) {
                words_.fail(
                    fmt::format("POINT_DATA is of {} points; there are {}", tuples_, count));
            }
        } else if (key == "METADATA") {
            words_.rest_of_line();
            for (auto line = words_.rest_of_line(); line && !line->empty();)
                line = words_.rest_of_line();
        } else if (key == "FIELD") {
            words_.need("the field's name");
            const std::size_t fields = words_.count("the number of a field's arrays");
            for (std::size_t k = 0; k < fields; ++k) {
                if (words_.meets("METADATA")) {
                    part("METADATA");
                    --k;
                    continue;
                }
                const std::string name(words_.need("an array of the field"));
                if (name == "NULL_ARRAY") continue;
                const std::size_t components = words_.count("an array's number of components");
                const std::size_t tuples = words_.count("an array's number of tuples");
                const std::string_view type = words_.need("an array's type");
                if (of_points_ && tuples != count) {
                    words_.fail(
                        fmt::format("'{}' has {} tuples for {} points", name, tuples, count));
                }
                array(name, components, type, tuples);
            }
        } else {
            attribute(key);
        }
    }

    void attribute(std::string_view key) {
        if (key == "LOOKUP_TABLE") { // of colours
            words_.need("a table's name");
            const std::size_t colours = words_.count("a table's number of colours");
            skip(4, is_ascii ? Scalar::f32 : Scalar::u8, colours);
            return;
        }
        const bool known = key == "SCALARS" || key == "VECTORS" || key == "NORMALS" ||
                           key == "TENSORS" || key == "TENSORS6" || key == "TEXTURE_COORDINATES" ||
                           key == "COLOR_SCALARS" || key == "GLOBAL_IDS" || key == "PEDIGREE_IDS";
        if (!known)
            words_.fail(
                fmt::format("'{}' is no part of legacy VTK that is read", key.substr(0, 60)));
        const std::string name(words_.need("an attribute's name"));
        std::size_t components = 1;
        if (key == "TEXTURE_COORDINATES" || key == "COLOR_SCALARS")
            components = words_.count("an attribute's number of components");
        // Colours are from 0 to 1 in a text, and from 0 to 255 in binary.
        if (key == "COLOR_SCALARS")
            return array(name, components, is_ascii ? "float" : "unsigned_char", tuples_);
        const std::string_view type = words_.need("an attribute's type");
        if (key == "VECTORS" || key == "NORMALS") components = 3;
        if (key == "TENSORS") components = 9;
        if (key == "TENSORS6") components = 6;
        if (key == "SCALARS") {
            const std::string_view rest = words_.rest_of_line().value_or("");
            if (!rest.empty()) {
                const Number number = number_of(rest);
                if (!(number.value >= 1 && number.value <= 1000))
                    words_.fail("the number of components must be a whole number above 0");
                components = std::size_t(number.value);
            }
            if (words_.meets("LOOKUP_TABLE")) {
                words_.need("a table's name");
                words_.rest_of_line();
            }
            return keep(name, components, type_of(words_, type), tuples_, true);
        }
        array(name, components, type, tuples_);
    }

    void cells() {
        const std::size_t offsets = words_.count("the number of cells");
        const std::size_t size = words_.count("the size of the cells");
        words_.rest_of_line();
        if (version_ >= 5 && words_.meets("OFFSETS")) {
            array("", 1, words_.need("the type of the offsets"), offsets, false);
            if (!words_.meets("CONNECTIVITY")) words_.fail("CONNECTIVITY must follow here");
            array("", 1, words_.need("the type of the connectivity"), size, false);
            return;
        }
        skip(1, Scalar::i32, size);
    }

    // An array below the line that is being read.
    void array(const std::string& name, std::size_t components, std::string_view type,
               std::size_t tuples, bool may_be_kept = true) {
        const Scalar scalar = type_of(words_, type);
        if (const auto rest = words_.rest_of_line(); rest && !rest->empty())
            words_.fail(fmt::format("the line goes on with '{}'", rest->substr(0, 60)));
        keep(name, components, scalar, tuples, may_be_kept);
    }
    // One that begins here.
    void keep(const std::string& name, std::size_t components, Scalar scalar, std::size_t tuples,
              bool may_be_kept) {
        if (components == 0 || components > std::size_t(limits::fields)) {
            words_.fail(fmt::format("'{}' has {} components; 1 to {} are read", name, components,
                                    limits::fields));
        }
        if (of_points_ && may_be_kept && !name.empty()) {
            arrays.push_back({name, components, scalar, words_.at()});
            if (arrays.size() > std::size_t(limits::fields))
                words_.fail(fmt::format("has more than {} arrays", limits::fields));
        }
        skip(components, scalar, tuples);
    }

    void skip(std::size_t components, Scalar type, std::size_t tuples) {
        // Each number takes a byte at least.
        if (tuples > words_.left() || tuples * components > words_.left()) {
            words_.fail(fmt::format("{} times {} numbers belong here; the file has {} bytes left",
                                    tuples, components, words_.left()));
        }
        if (!is_ascii) {
            words_.take(tuples * components * size_of(type), "an array");
            return;
        }
        for (std::size_t k = 0; k < tuples * components; ++k) words_.need("an array's end");
    }

    Words words_;
    bool count_alone_;
    int version_ = 3;
    bool has_points_ = false;
    bool of_points_ = false; // what follows
    std::size_t tuples_ = 0;
};

} // namespace

ParticleTable read_vtk(const Bytes& bytes, const ParticleRequest& request) {
    VtkReader reader(request, *bytes);
    reader.read();
    ParticleTable table;
    table.format = reader.is_ascii ? "legacy VTK, ascii" : "legacy VTK, binary";
    table.count = reader.count;
    if (request.count_alone) return table;
    std::vector<std::string> names;
    for (const PointArray& array : reader.arrays) {
        if (names.size() + array.components > std::size_t(limits::fields))
            fail_of_file(request, fmt::format("has more than {} columns", limits::fields));
        add_names(names, array.name, array.components);
    }
    const Wanted wanted = wanted_of(request, table.format, names, table.count);
    std::vector<Scalar> types;
    for (const PointArray& array : reader.arrays) {
        const std::size_t first = table.columns.size(), size = size_of(array.type);
        types.insert(types.end(), array.components, array.type);
        for (std::size_t c = 0; c < array.components; ++c) {
            table.columns.push_back({names[first + c], {}});
            if (reader.is_ascii) continue;
            table.columns.back().values =
                RawColumn{bytes->data() + array.at + c * size, array.components * size, array.type,
                          true, bytes->data()};
        }
        if (!reader.is_ascii) continue;
        Words words(request, *bytes, array.at);
        for (std::size_t row = 0; row < table.count; ++row) {
            for (std::size_t c = 0; c < array.components; ++c) {
                const std::string_view word = words.need("an array's end");
                if (!wanted.columns[first + c]) continue;
                std::get<std::vector<double>>(table.columns[first + c].values)
                    .push_back(words.number(word, names[first + c]));
            }
        }
    }
    scale_colors(table, types);
    table.kept.push_back(bytes);
    return table;
}

} // namespace isomotion::scene

#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/formats.h"
#include "scene/particles/vtu_data.h"
#include "scene/particles/words.h"
#include "scene/particles/xml_tags.h"

namespace isomotion::scene {
namespace {

struct VtuArray {
    std::string name;
    Scalar type = Scalar::f32;
    std::size_t components = 1;
    enum class Format { ascii, binary, appended } format = Format::ascii;
    std::size_t at = 0, end = 0; // of its text; of an appended one `at` counts from there
    std::size_t tag = 0;         // its byte
};

std::optional<Scalar> vtu_type(std::string_view name) {
    constexpr std::pair<std::string_view, Scalar> known[] = {
        {"Int8", Scalar::i8},    {"UInt8", Scalar::u8},   {"Int16", Scalar::i16},
        {"UInt16", Scalar::u16}, {"Int32", Scalar::i32},  {"UInt32", Scalar::u32},
        {"Int64", Scalar::i64},  {"UInt64", Scalar::u64}, {"Float32", Scalar::f32},
        {"Float64", Scalar::f64}};
    for (const auto& [spelling, type] : known) {
        if (spelling == name) return type;
    }
    return std::nullopt;
}

class VtuReader {
public:
    VtuReader(const ParticleRequest& request, std::string_view text)
        : request_(request)
        , text_(text)
        , tags_(request, text) {}

    void read() {
        for (;;) {
            const auto tag = tags_.next();
            if (!tag) break;
            if (tag->name == "AppendedData" && tag->begins) {
                appended(*tag);
                break;
            }
            if (tag->begins) begin(*tag);
            if (!tag->begins || tag->is_whole) end(*tag);
            if (request_.count_alone && has_piece_) return;
        }
        if (!is_vtk_) fail_of_file(request_, "is XML, but has no <VTKFile>");
        if (!has_piece_) fail_of_file(request_, "ends before a <Piece NumberOfPoints=...>");
        if (!has_places_) fail_of_file(request_, "has no <Points>");
    }

    std::size_t count = 0;
    std::vector<VtuArray> arrays; // first the places
    VtuCoding coding;
    std::size_t appended_at = 0; // the byte that offsets count from, or 0
    bool appended_is_base64 = true;
    std::string kind;

private:
    [[noreturn]] void fail(const XmlTag& tag, const std::string& message) const {
        fail_at_byte(request_, tag.at, message);
    }

    std::size_t whole(const XmlTag& tag, std::string_view attribute,
                      std::optional<std::size_t> without = {}) const {
        const std::string_view text = trimmed(tag.attribute(attribute));
        if (text.empty() && without) return *without;
        std::size_t value = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
        if (error != std::errc() || end != text.data() + text.size() || text.empty()) {
            fail(tag,
                 fmt::format("{} must be a whole number, not '{}'", attribute, text.substr(0, 60)));
        }
        return value;
    }

    void begin(const XmlTag& tag) {
        if (tag.name == "VTKFile") {
            file(tag);
        } else if (!is_vtk_) {
            fail(tag,
                 fmt::format("is XML, but no VTK: it begins with <{}>", tag.name.substr(0, 60)));
        } else if (tag.name == "Piece") {
            if (has_piece_) fail(tag, "has a second piece; one is read");
            count = whole(tag, "NumberOfPoints");
            has_piece_ = true;
        } else if (tag.name == "PointData" || tag.name == "Points") {
            within_ = tag.name;
        } else if (tag.name == "DataArray" && !within_.empty()) {
            array(tag);
        }
    }

    void end(const XmlTag& tag) {
        if (tag.name == within_) within_ = {};
    }

    void file(const XmlTag& tag) {
        is_vtk_ = true;
        kind = tag.attribute("type");
        if (kind != "UnstructuredGrid" && kind != "PolyData") {
            fail(tag, fmt::format("the type is '{}'; UnstructuredGrid and PolyData are read",
                                  kind.substr(0, 60)));
        }
        coding.big_endian = tag.attribute("byte_order") == "BigEndian";
        coding.has_long_headers = tag.attribute("header_type") == "UInt64";
        const std::string_view compressor = tag.attribute("compressor");
        coding.is_packed = compressor == "vtkZLibDataCompressor";
        if (!compressor.empty() && !coding.is_packed) {
            fail(tag, fmt::format("is packed by '{}'; vtkZLibDataCompressor is read",
                                  compressor.substr(0, 60)));
        }
    }

    void array(const XmlTag& tag) {
        VtuArray array;
        const auto type = vtu_type(tag.attribute("type"));
        if (!type) return; // texts
        array.type = *type;
        array.tag = tag.at;
        array.name = tag.attribute("Name");
        array.components = whole(tag, "NumberOfComponents", 1);
        if (array.components == 0 || array.components > std::size_t(limits::fields)) {
            fail(tag, fmt::format("has {} components; 1 to {} are read", array.components,
                                  limits::fields));
        }
        const std::string_view format = tag.attribute("format");
        array.at = tag.end;
        array.end = tag.is_whole ? tag.end : tags_.end_of_text();
        if (format == "appended") {
            array.format = VtuArray::Format::appended;
            array.at = whole(tag, "offset");
        } else if (format == "binary") {
            array.format = VtuArray::Format::binary;
        } else if (format != "ascii") {
            fail(tag, fmt::format("the format is '{}'; ascii, binary and appended are read",
                                  format.substr(0, 60)));
        }
        if (arrays.size() == std::size_t(limits::fields))
            fail(tag, fmt::format("has more than {} arrays", limits::fields));
        if (within_ == "Points") {
            if (has_places_) fail(tag, "has a second array of places");
            if (array.components != 3) fail(tag, "places must have three components");
            array.name = "position";
            has_places_ = true;
            arrays.insert(arrays.begin(), array);
        } else {
            arrays.push_back(array);
        }
    }

    void appended(const XmlTag& tag) {
        const std::string_view encoding = tag.attribute("encoding");
        if (encoding != "raw" && encoding != "base64") {
            fail(tag, fmt::format("the encoding is '{}'; raw and base64 are read",
                                  encoding.substr(0, 60)));
        }
        appended_is_base64 = encoding == "base64";
        const std::size_t mark = text_.find('_', tag.end);
        if (mark == text_.npos) fail(tag, "the appended data do not begin with _");
        appended_at = mark + 1;
    }

    const ParticleRequest& request_;
    std::string_view text_;
    XmlTags tags_;
    bool is_vtk_ = false, has_piece_ = false, has_places_ = false;
    std::string_view within_; // PointData or Points
};

void read_numbers(const ParticleRequest& request, std::string_view text, const VtuArray& array,
                  const Wanted& wanted, std::size_t first, ParticleTable& table) {
    Words words(request, text.substr(0, array.end), array.at);
    const std::string what = fmt::format("the end of '{}'", array.name);
    for (std::size_t row = 0; row < table.count; ++row) {
        for (std::size_t c = 0; c < array.components; ++c) {
            const std::string& name = table.columns[first + c].name;
            const std::string_view word = words.need(what);
            if (!wanted.columns[first + c]) continue;
            std::get<std::vector<double>>(table.columns[first + c].values)
                .push_back(words.number(word, name));
        }
    }
    if (!words.next().empty())
        words.fail(
            fmt::format("'{}' has more numbers than {} points need", array.name, table.count));
}

} // namespace

ParticleTable read_vtu(const Bytes& bytes, const ParticleRequest& request) {
    VtuReader reader(request, *bytes);
    reader.read();
    ParticleTable table;
    table.format = reader.kind == "PolyData" ? "VTP" : "VTU";
    table.count = reader.count;
    if (request.count_alone) return table;
    std::vector<std::string> names;
    for (const VtuArray& array : reader.arrays) {
        if (names.size() + array.components > std::size_t(limits::fields))
            fail_of_file(request, fmt::format("has more than {} columns", limits::fields));
        add_names(names, array.name, array.components);
    }
    const Wanted wanted = wanted_of(request, table.format, names, table.count);
    std::size_t memory = limits::table_bytes;
    std::vector<Scalar> types;
    for (const VtuArray& array : reader.arrays) {
        const std::size_t first = table.columns.size();
        types.insert(types.end(), array.components, array.type);
        bool is_wanted = false;
        for (std::size_t c = 0; c < array.components; ++c) {
            table.columns.push_back({names[first + c], {}});
            is_wanted = is_wanted || wanted.columns[first + c];
        }
        if (!is_wanted) continue;
        if (array.format == VtuArray::Format::ascii) {
            read_numbers(request, *bytes, array, wanted, first, table);
            continue;
        }
        const std::size_t stride = array.components * size_of(array.type);
        const std::size_t size = table.count * stride;
        if (size > memory) {
            fail_at_byte(request, array.tag,
                         fmt::format("the arrays that are read have more than {} bytes",
                                     limits::table_bytes));
        }
        memory -= size;
        VtuCoding coding = reader.coding;
        std::string_view text(*bytes);
        std::size_t at = array.at;
        if (array.format == VtuArray::Format::appended) {
            if (reader.appended_at == 0)
                fail_at_byte(request, array.tag, "there are no <AppendedData>");
            coding.is_base64 = reader.appended_is_base64;
            if (at > text.size() - reader.appended_at)
                fail_at_byte(request, array.tag, "the offset leads beyond the end of the file");
            at += reader.appended_at;
        } else {
            text = text.substr(0, array.end);
        }
        table.kept.push_back(
            std::make_shared<const std::string>(vtu_data(request, text, at, coding, size)));
        const char* data = table.kept.back()->data();
        for (std::size_t c = 0; c < array.components; ++c) {
            table.columns[first + c].values = RawColumn{data + c * size_of(array.type), stride,
                                                        array.type, coding.big_endian, nullptr};
        }
    }
    scale_colors(table, types);
    return table;
}

} // namespace isomotion::scene

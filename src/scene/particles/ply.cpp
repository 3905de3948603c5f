#include <optional>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/byte_cursor.h"
#include "scene/particles/formats.h"
#include "scene/particles/words.h"

namespace isomotion::scene {
namespace {

struct Property {
    std::string name;
    Scalar type = Scalar::f32;      // of a list's entries
    std::optional<Scalar> length{}; // of a list's length, if it is one
};

struct Element {
    std::string name;
    std::size_t count = 0;
    std::vector<Property> properties{};
};

enum class Encoding { ascii, little, big };

struct Header {
    Encoding encoding = Encoding::ascii;
    std::vector<Element> before{}; // of the vertices
    Element vertices{};
};

std::optional<Scalar> scalar_of(std::string_view name) {
    constexpr std::pair<std::string_view, Scalar> known[] = {
        {"char", Scalar::i8},    {"uchar", Scalar::u8},   {"short", Scalar::i16},
        {"ushort", Scalar::u16}, {"int", Scalar::i32},    {"uint", Scalar::u32},
        {"float", Scalar::f32},  {"double", Scalar::f64}, {"int8", Scalar::i8},
        {"uint8", Scalar::u8},   {"int16", Scalar::i16},  {"uint16", Scalar::u16},
        {"int32", Scalar::i32},  {"uint32", Scalar::u32}, {"float32", Scalar::f32},
        {"float64", Scalar::f64}};
    for (const auto& [spelling, type] : known) {
        if (spelling == name) return type;
    }
    return std::nullopt;
}

class HeaderReader {
public:
    HeaderReader(Words& words)
        : words_(words) {}

    Header read() {
        words_.rest_of_line(); // ply
        Header header;
        std::vector<Element> elements;
        for (bool has_format = false;;) {
            const std::string_view key = words_.need("end_header");
            if (key == "end_header") {
                if (!has_format) words_.fail("the header has no line `format`");
                break;
            }
            if (key == "format") {
                header.encoding = encoding(words_.need("the format"));
                has_format = true;
            } else if (key == "element") {
                Element element{std::string(words_.need("an element's name"))};
                element.count = words_.count(fmt::format("the number of '{}'", element.name));
                elements.push_back(std::move(element));
                if (elements.size() > std::size_t(limits::fields))
                    words_.fail(
                        fmt::format("the header has more than {} elements", limits::fields));
            } else if (key == "property") {
                if (elements.empty()) words_.fail("a property stands before every element");
                elements.back().properties.push_back(property());
                if (elements.back().properties.size() > std::size_t(limits::fields)) {
                    words_.fail(fmt::format("'{}' has more than {} properties",
                                            elements.back().name, limits::fields));
                }
            } else if (key != "comment" && key != "obj_info") {
                words_.fail(fmt::format("the header has a line '{}'; format, element, property, "
                                        "comment, obj_info and end_header are known",
                                        key.substr(0, 60)));
            }
            words_.rest_of_line();
        }
        words_.rest_of_line(); // end_header
        for (Element& element : elements) {
            if (element.name == "vertex") {
                header.vertices = std::move(element);
                return header;
            }
            header.before.push_back(std::move(element));
        }
        words_.fail("the header has no element `vertex`");
    }

private:
    Encoding encoding(std::string_view name) const {
        if (name == "ascii") return Encoding::ascii;
        if (name == "binary_little_endian") return Encoding::little;
        if (name == "binary_big_endian") return Encoding::big;
        words_.fail(fmt::format("the format is '{}'; ascii, binary_little_endian and "
                                "binary_big_endian are read",
                                name.substr(0, 60)));
    }

    Scalar type() {
        const std::string_view name = words_.need("a property's type");
        if (const auto type = scalar_of(name)) return *type;
        words_.fail(fmt::format("'{}' is no type of PLY", name.substr(0, 60)));
    }

    Property property() {
        Property property;
        std::string_view name = words_.need("a property's type");
        if (name == "list") {
            property.length = type();
            property.type = type();
        } else if (const auto known = scalar_of(name)) {
            property.type = *known;
        } else {
            words_.fail(fmt::format("'{}' is no type of PLY", name.substr(0, 60)));
        }
        property.name = words_.need("a property's name");
        return property;
    }

    Words& words_;
};

std::size_t length_of_list(ByteCursor& in, Scalar type) {
    double length = 0;
    switch (type) {
    case Scalar::i8:
        length = in.number<std::int8_t>("a list");
        break;
    case Scalar::u8:
        length = in.number<std::uint8_t>("a list");
        break;
    case Scalar::i16:
        length = in.number<std::int16_t>("a list");
        break;
    case Scalar::u16:
        length = in.number<std::uint16_t>("a list");
        break;
    case Scalar::i32:
        length = in.number<std::int32_t>("a list");
        break;
    case Scalar::u32:
        length = in.number<std::uint32_t>("a list");
        break;
    default:
        in.fail("a list's length is no whole number");
    }
    if (length < 0) in.fail("a list's length is below 0");
    return std::size_t(length);
}

void skip(ByteCursor& in, const Element& element) {
    std::size_t fixed = 0;
    bool has_lists = false;
    for (const Property& property : element.properties) {
        fixed += size_of(property.type);
        has_lists = has_lists || property.length;
    }
    if (!has_lists) {
        if (fixed > 0 && element.count > in.left() / fixed)
            in.fail(fmt::format("the file ends in its {} '{}'", element.count, element.name));
        in.take(element.count * fixed, element.name);
        return;
    }
    for (std::size_t k = 0; k < element.count; ++k) {
        for (const Property& property : element.properties) {
            const std::size_t length = property.length ? length_of_list(in, *property.length) : 1;
            in.take(length * size_of(property.type), element.name);
        }
    }
}

void skip(Words& words, const Element& element) {
    for (std::size_t k = 0; k < element.count && !element.properties.empty(); ++k) {
        for (const Property& property : element.properties) {
            std::size_t length = 1;
            if (property.length) length = words.count("a list's length");
            for (std::size_t i = 0; i < length; ++i) words.need(element.name);
        }
    }
}

void read_ascii(Words& words, const Header& header, const Wanted& wanted,
                const std::vector<std::string>& names, ParticleTable& table) {
    for (const Element& element : header.before) skip(words, element);
    // Each number has a byte at least, and one before the next.
    if (2 * double(names.size()) * double(table.count) > double(words.left()) + 2) {
        words.fail(fmt::format("the header says that there are {} vertices of {} numbers; the file "
                               "has {} bytes for them",
                               table.count, names.size(), words.left()));
    }
    std::vector<std::vector<double>> values(names.size());
    for (std::size_t k = 0; k < names.size(); ++k) {
        if (wanted.columns[k]) values[k].reserve(table.count);
    }
    for (std::size_t row = 0; row < table.count; ++row) {
        for (std::size_t k = 0; k < names.size(); ++k) {
            const std::string_view word = words.need("the last vertex");
            if (k == 0) table.lines.push_back(words.line());
            if (wanted.columns[k]) values[k].push_back(words.number(word, names[k]));
        }
    }
    for (std::size_t k = 0; k < names.size(); ++k)
        table.columns.push_back({names[k], std::move(values[k])});
}

} // namespace

ParticleTable read_ply(const Bytes& bytes, const ParticleRequest& request) {
    Words words(request, *bytes);
    const Header header = HeaderReader(words).read();
    ParticleTable table;
    table.format = header.encoding == Encoding::ascii    ? "PLY, ascii"
                   : header.encoding == Encoding::little ? "PLY, binary little-endian"
                                                         : "PLY, binary big-endian";
    table.count = header.vertices.count;
    if (request.count_alone) return table;
    std::vector<std::string> names;
    std::vector<std::size_t> places;
    std::vector<Scalar> types;
    std::size_t stride = 0;
    for (const Property& property : header.vertices.properties) {
        if (property.length)
            words.fail(
                fmt::format("the vertices have a list, '{}'; numbers are read", property.name));
        add_names(names, property.name, 1);
        places.push_back(stride);
        types.push_back(property.type);
        stride += size_of(property.type);
    }
    if (names.empty()) words.fail("the vertices have no property");
    const Wanted wanted = wanted_of(request, table.format, names, table.count);
    if (header.encoding == Encoding::ascii) {
        read_ascii(words, header, wanted, names, table);
        scale_colors(table, types);
        return table;
    }
    const bool is_big = header.encoding == Encoding::big;
    ByteCursor in(request, *bytes, is_big);
    in.take(words.at(), "the header");
    for (const Element& element : header.before) skip(in, element);
    const std::string_view rows = in.take(table.count * stride, "its vertices");
    for (std::size_t k = 0; k < names.size(); ++k) {
        table.columns.push_back({names[k], RawColumn{rows.data() + places[k], stride, types[k],
                                                     is_big, bytes->data()}});
    }
    scale_colors(table, types);
    table.kept.push_back(bytes);
    return table;
}

} // namespace isomotion::scene

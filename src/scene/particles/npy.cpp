#include <cctype>
#include <charconv>
#include <optional>

#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/byte_cursor.h"
#include "scene/particles/formats.h"

namespace isomotion::scene {
namespace {

// A field of an array's records, or the array's numbers.
struct Field {
    std::string name;
    std::string type; // "<f4"
    std::size_t count = 1;
};

// The dictionary of an array's header, a literal of Python.
class Dictionary {
public:
    Dictionary(const ParticleRequest& request, std::string_view text, std::size_t first_byte)
        : request_(request)
        , text_(text)
        , first_byte_(first_byte) {}

    void read() {
        expect('{');
        while (!meets('}')) {
            const std::string key = text();
            expect(':');
            if (key == "descr") {
                description();
            } else if (key == "fortran_order") {
                by_columns = word() == "True";
            } else if (key == "shape") {
                shape = whole_numbers();
                has_shape_ = true;
            } else {
                fail(fmt::format("the header has a key '{}'", key.substr(0, 60)));
            }
            if (!meets(',')) {
                expect('}');
                break;
            }
        }
        if (fields.empty() || !has_shape_) fail("the header has no descr, or no shape");
    }

    std::vector<Field> fields; // one without a name where there are no records
    bool has_records = false;
    bool by_columns = false;
    std::vector<std::size_t> shape;

    [[noreturn]] void fail(const std::string& message) const {
        fail_at_byte(request_, first_byte_ + at_, message);
    }

private:
    void skip_blanks() {
        while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\n')) ++at_;
    }
    bool meets(char c) {
        skip_blanks();
        if (at_ >= text_.size() || text_[at_] != c) return false;
        ++at_;
        return true;
    }
    void expect(char c) {
        if (!meets(c)) fail(fmt::format("the header needs a '{}' here", c));
    }
    std::string text() {
        skip_blanks();
        const char quote = at_ < text_.size() ? text_[at_] : ' ';
        if (quote != '\'' && quote != '"') fail("the header needs a text in quotes here");
        const std::size_t end = text_.find(quote, at_ + 1);
        if (end == text_.npos) fail("the text has no end");
        const std::string_view inside = text_.substr(at_ + 1, end - at_ - 1);
        at_ = end + 1;
        return std::string(inside);
    }
    std::string_view word() {
        skip_blanks();
        const std::size_t begin = at_;
        while (at_ < text_.size() && (std::isalpha(static_cast<unsigned char>(text_[at_])))) ++at_;
        return text_.substr(begin, at_ - begin);
    }
    std::size_t whole_number() {
        skip_blanks();
        std::size_t value = 0;
        const char* end = text_.data() + text_.size();
        const auto [after, error] = std::from_chars(text_.data() + at_, end, value);
        if (error != std::errc()) fail("the header needs a whole number here");
        at_ = std::size_t(after - text_.data());
        if (at_ < text_.size() && text_[at_] == 'L') ++at_; // of Python 2
        return value;
    }
    std::vector<std::size_t> whole_numbers() {
        std::vector<std::size_t> numbers;
        expect('(');
        while (!meets(')')) {
            if (numbers.size() == 8) fail("has more than 8 dimensions");
            numbers.push_back(whole_number());
            if (!meets(',')) {
                expect(')');
                break;
            }
        }
        return numbers;
    }
    void description() {
        fields.clear();
        has_records = meets('[');
        if (!has_records) {
            fields.push_back({"", text()});
            return;
        }
        while (!meets(']')) {
            expect('(');
            Field field{text(), {}};
            expect(',');
            skip_blanks();
            if (at_ < text_.size() && text_[at_] == '[')
                fail(fmt::format("'{}' is a record of records; numbers and lists of them are read",
                                 field.name));
            field.type = text();
            if (meets(',') && !meets(')')) {
                for (const std::size_t size : whole_numbers()) {
                    field.count *= size;
                    if (field.count > std::size_t(limits::fields))
                        fail(fmt::format("'{}' has more than {} numbers", field.name,
                                         limits::fields));
                }
                expect(')');
            } else if (text_[at_ - 1] != ')') {
                expect(')');
            }
            fields.push_back(std::move(field));
            if (fields.size() > std::size_t(limits::fields))
                fail(fmt::format("has more than {} columns", limits::fields));
            if (!meets(',')) {
                expect(']');
                break;
            }
        }
        if (fields.empty()) fail("the records have no field");
    }

    const ParticleRequest& request_;
    std::string_view text_;
    std::size_t first_byte_;
    std::size_t at_ = 0;
    bool has_shape_ = false;
};

struct Stored {
    std::optional<Scalar> scalar; // none of what is skipped
    std::size_t size = 0;
    bool is_big = false;
};

Stored kind_of(const Dictionary& header, const Field& field) {
    const std::string_view type = field.type;
    std::size_t size = 0;
    const char* end = type.data() + type.size();
    if (type.size() >= 3) {
        const auto [after, error] = std::from_chars(type.data() + 2, end, size);
        if (error == std::errc() && after == end && size <= 1'000'000) {
            const bool is_big = type[0] == '>';
            const char letter = type[1];
            for (const Scalar scalar : {Scalar::i8, Scalar::i16, Scalar::i32, Scalar::i64}) {
                if (letter == 'i' && size == size_of(scalar)) return {scalar, size, is_big};
            }
            for (const Scalar scalar : {Scalar::u8, Scalar::u16, Scalar::u32, Scalar::u64}) {
                if (letter == 'u' && size == size_of(scalar)) return {scalar, size, is_big};
            }
            if (letter == 'b' && size == 1) return {Scalar::u8, size, is_big};
            if (letter == 'f' && size == 4) return {Scalar::f32, size, is_big};
            if (letter == 'f' && size == 8) return {Scalar::f64, size, is_big};
            // Padding, and texts beside the numbers.
            if (letter == 'V' || letter == 'S') return {std::nullopt, size, is_big};
            if (letter == 'U') return {std::nullopt, 4 * size, is_big};
        }
    }
    header.fail(fmt::format("{}the type is '{}'; f4, f8, i1 to i8, u1 to u8 and b1 are read",
                            field.name.empty() ? "" : fmt::format("'{}': ", field.name),
                            type.substr(0, 60)));
}

} // namespace

ParticleTable read_npy(const Bytes& bytes, const ParticleRequest& request) {
    ByteCursor in(request, *bytes, false);
    in.take(6, "the header");
    const auto version = in.number<std::uint8_t>("the header");
    in.take(1, "the header");
    if (version < 1 || version > 3)
        in.fail(fmt::format("is of version {}; 1 to 3 are read", version));
    const std::size_t length = version == 1 ? in.number<std::uint16_t>("the header")
                                            : in.number<std::uint32_t>("the header");
    const std::size_t first = in.at();
    Dictionary header(request, in.take(length, "the header"), first);
    header.read();
    const std::size_t dimensions = header.has_records ? 1 : 2;
    if (header.shape.size() != dimensions) {
        header.fail(fmt::format("is of {} dimensions; two, a particle a row, or records of one are "
                                "read",
                                header.shape.size()));
    }
    ParticleTable table;
    table.format = "NPY";
    table.count = header.shape[0];
    if (request.count_alone) return table;

    std::vector<std::string> names;
    struct Place {
        std::size_t byte;
        Scalar scalar;
        bool is_big;
    };
    std::vector<Place> places;
    std::size_t stride = 0;
    if (header.has_records) {
        for (const Field& field : header.fields) {
            const Stored kind = kind_of(header, field);
            if (const auto& scalar = kind.scalar) {
                if (names.size() + field.count > std::size_t(limits::fields))
                    header.fail(fmt::format("has more than {} columns", limits::fields));
                add_names(names, field.name, field.count);
                for (std::size_t i = 0; i < field.count; ++i)
                    places.push_back({stride + i * kind.size, *scalar, kind.is_big});
            }
            stride += field.count * kind.size;
        }
        table.format = "NPY, records";
    } else {
        const Stored kind = kind_of(header, header.fields[0]);
        const std::size_t columns = header.shape[1];
        const auto& scalar = kind.scalar;
        if (!scalar) header.fail("holds texts, not numbers");
        if (columns == 0 || columns > std::size_t(limits::fields))
            header.fail(fmt::format("has {} columns; 1 to {} are read", columns, limits::fields));
        names = names_without_names(columns);
        stride = kind.size * (header.by_columns ? 1 : columns);
        for (std::size_t k = 0; k < columns; ++k)
            places.push_back({k * kind.size, *scalar, kind.is_big});
    }
    if (names.empty()) header.fail("the records have no number");
    const Wanted wanted = wanted_of(request, table.format, names, table.count);
    if (header.by_columns && !header.has_records) {
        for (std::size_t k = 0; k < places.size(); ++k) places[k].byte *= table.count;
    }
    const std::size_t size =
        header.by_columns && !header.has_records ? stride * names.size() : stride;
    const std::string_view data = in.take(table.count * size, "its numbers");
    for (std::size_t k = 0; k < names.size(); ++k) {
        table.columns.push_back(
            {names[k], RawColumn{data.data() + places[k].byte, stride, places[k].scalar,
                                 places[k].is_big, bytes->data()}});
    }
    std::vector<Scalar> types;
    for (const Place& place : places) types.push_back(place.scalar);
    scale_colors(table, types);
    table.kept.push_back(bytes);
    return table;
}

} // namespace isomotion::scene

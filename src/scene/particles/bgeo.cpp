#include <fmt/format.h>

#include "scene/limits.h"
#include "scene/particles/attribute_names.h"
#include "scene/particles/byte_cursor.h"
#include "scene/particles/formats.h"

namespace isomotion::scene {
namespace {

enum Kind { reals = 0, whole = 1, text = 2, indexed_text = 4, vector = 5 };

} // namespace

ParticleTable read_bgeo(const Bytes& bytes, const ParticleRequest& request) {
    ByteCursor in(request, *bytes, true);
    in.take(5, "the header"); // BgeoV
    if (const auto version = in.number<std::int32_t>("the header"); version != 5)
        in.fail(fmt::format("is of version {}; version 5 is read", version));
    ParticleTable table;
    table.format = "BGEO";
    table.count = in.count("the number of points");
    if (request.count_alone) return table;
    in.take(3 * 4, "the header"); // primitives, groups of points and of primitives
    const std::size_t attributes = in.count("the number of point attributes");
    in.take(3 * 4, "the header"); // attributes of vertices, primitives and the whole

    // A point has x y z w, then its attributes, in words of four bytes.
    std::vector<std::string> names{"x", "y", "z"};
    struct Place {
        std::size_t word;
        Scalar type;
    };
    std::vector<Place> places{{0, Scalar::f32}, {1, Scalar::f32}, {2, Scalar::f32}};
    std::size_t words = 4;
    for (std::size_t k = 0; k < attributes; ++k) {
        const std::string name(in.take(in.number<std::uint16_t>("an attribute"), "an attribute"));
        const auto size = std::size_t(in.number<std::uint16_t>("an attribute"));
        const auto kind = in.number<std::int32_t>("an attribute");
        if (kind == indexed_text) {
            const std::size_t texts = in.count("the number of an attribute's texts");
            for (std::size_t i = 0; i < texts; ++i)
                in.take(in.number<std::uint16_t>("an attribute's texts"), "an attribute's texts");
        } else if (kind == reals || kind == whole || kind == vector) {
            in.take(4 * size, "an attribute's defaults");
            if (names.size() + size > std::size_t(limits::fields))
                in.fail(fmt::format("has more than {} columns", limits::fields));
            add_names(names, name, size);
            for (std::size_t i = 0; i < size; ++i)
                places.push_back({words + i, kind == whole ? Scalar::i32 : Scalar::f32});
        } else {
            in.fail(fmt::format("the attribute '{}' is of kind {}; numbers (0), whole numbers (1), "
                                "indexed texts (4) and vectors (5) are read",
                                name, kind));
        }
        words += size;
    }

    const Wanted wanted = wanted_of(request, table.format, names, table.count);
    const std::string_view points = in.take(table.count * 4 * words, "its points");
    for (std::size_t k = 0; k < names.size(); ++k) {
        table.columns.push_back({names[k], RawColumn{points.data() + 4 * places[k].word, 4 * words,
                                                     places[k].type, true, bytes->data()}});
    }
    table.kept.push_back(bytes);
    return table;
}

} // namespace isomotion::scene

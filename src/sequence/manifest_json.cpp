#include "sequence/manifest_json.h"

#include <concepts>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "animation/frame_range.h"
#include "base/document.h"
#include "base/input_error.h"
#include "base/printable.h"

namespace isomotion::sequence {
namespace {

using Json = nlohmann::ordered_json; // keys as they were added

// The two directions of fields(), which names each key once.
class Writer {
public:
    template<class T> void operator()(const char* key, const T& value) { json_[key] = value; }
    // Drivers' names and files' may be of any bytes.
    void operator()(const char* key, const std::string& value) {
        json_[key] = base::printable_line(value);
    }
    void operator()(const char* key, const Provenance& value);

    void where_known(const char* key, std::int64_t value) { json_[key] = value; }
    void seconds(const char* key, double value) { json_[key] = value; }
    void constant(const char* key, std::string_view value) { json_[key] = value; }
    void size(const char* key, int width, int height) { json_[key] = Json::array({width, height}); }
    void frames(const char* key, const std::vector<int>& frames) {
        json_[key] = animation::frame_range(frames);
    }
    void numbers(const char* key, const std::vector<std::pair<std::string, double>>& numbers) {
        Json all = Json::object();
        for (const auto& [name, number] : numbers) all[name] = number;
        json_[key] = std::move(all);
    }
    // Counts by their names: {"miss": 3, "hit": 4}.
    template<class Counts, class Names>
    void counts(const char* key, const Counts& counts, const Names& names) {
        Json all = Json::object();
        for (std::size_t k = 0; k < counts.size(); ++k) all[std::string(names[k])] = counts[k];
        json_[key] = std::move(all);
    }
    template<class Counts, class Names>
    void counts(const char* key, const std::optional<Counts>& given, const Names& names) {
        if (given) counts(key, *given, names);
    }

    std::string text() const {
        return json_.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
    }

private:
    Json json_ = Json::object();
};

class Reader {
public:
    explicit Reader(base::DocumentTable table)
        : table_(std::move(table)) {}

    void operator()(const char* key, std::string& value) { value = line(table_.at(key)); }
    void operator()(const char* key, int& value) {
        value = table_.at(key).integer(std::numeric_limits<int>::min(),
                                       std::numeric_limits<int>::max());
    }
    void operator()(const char* key, std::int64_t& value) { value = count(table_.at(key)); }
    void operator()(const char* key, std::uintmax_t& value) {
        value = std::uintmax_t(count(table_.at(key)));
    }
    void operator()(const char* key, double& value) { value = number(table_.at(key)); }
    void operator()(const char* key, std::vector<std::string>& value) {
        value.clear();
        for (const base::DocumentNode& each : table_.at(key).list()) value.push_back(line(each));
    }
    void operator()(const char* key, Provenance& value);

    // Records of earlier versions don't have it.
    void where_known(const char* key, std::int64_t& value) {
        if (table_.find(key)) operator()(key, value);
    }
    void seconds(const char* key, double& value) {
        constexpr double most = 1e9; // thirty years
        const base::DocumentNode node = table_.at(key);
        value = number(node);
        if (!(value >= 0 && value <= most)) node.fail(fmt::format("must be from 0 to {:g}", most));
    }
    void constant(const char* key, std::string_view wanted) {
        const base::DocumentNode node = table_.at(key);
        if (node.text() != wanted) node.fail(fmt::format("must be \"{}\"", wanted));
    }
    void size(const char* key, int& width, int& height) {
        const auto sides = table_.at(key).list(2);
        width = sides[0].integer(1, std::numeric_limits<int>::max());
        height = sides[1].integer(1, std::numeric_limits<int>::max());
    }
    void frames(const char* key, std::vector<int>& frames) {
        const base::DocumentNode node = table_.at(key);
        const std::string text = node.text();
        try {
            if (!text.empty()) frames = animation::parse_frame_range(text);
        } catch (const std::invalid_argument& error) {
            node.fail(error.what());
        }
    }
    void numbers(const char* key, std::vector<std::pair<std::string, double>>& numbers) {
        base::DocumentTable all = table_.at(key).table();
        for (const base::DocumentNode& each : all.all()) {
            numbers.emplace_back(all.key_of(each), number(each));
        }
    }
    template<class Counts, class Names>
    void counts(const char* key, Counts& counts, const Names& names) {
        base::DocumentTable all = table_.at(key).table();
        for (std::size_t k = 0; k < counts.size(); ++k)
            counts[k] = count(all.at(std::string(names[k])));
    }
    template<class Counts, class Names>
    void counts(const char* key, std::optional<Counts>& given, const Names& names) {
        if (table_.find(key)) counts(key, given.emplace(), names);
    }

private:
    // Programs print what manifests say: none of it may move the cursor or begin a line.
    static std::string line(const base::DocumentNode& node) {
        std::string text = node.text();
        constexpr std::size_t most = 4096;
        if (text.size() > most || !base::is_one_printable_line(text))
            node.fail(fmt::format("must be one printable line of at most {} bytes", most));
        return text;
    }
    static std::int64_t count(const base::DocumentNode& node) {
        constexpr std::int64_t most = std::int64_t(1) << 54;
        const std::int64_t number = node.whole();
        if (number < 0 || number > most) node.fail(fmt::format("must be from 0 to {}", most));
        return number;
    }
    // JSON has no NaN and no infinity.
    static double number(const base::DocumentNode& node) {
        return node.is_null() ? std::numeric_limits<double>::quiet_NaN() : node.number();
    }

    base::DocumentTable table_;
};

template<class T, class U>
concept Is = std::same_as<std::remove_const_t<T>, U>;

template<class Visitor, Is<Provenance> P> void fields(Visitor& at, P& provenance) {
    at("scene", provenance.scene);
    at("shaders", provenance.shaders);
    at("version", provenance.version);
    at("renderer", provenance.renderer);
    at("stage", provenance.stage);
}

template<class Visitor, Is<Sequence> S> void fields(Visitor& at, S& sequence) {
    auto& format = sequence.format;
    at.constant("format", "isomotion sequence 1");
    at("title", sequence.title);
    at("scene file", sequence.scene_file);
    at("files", format.pattern);
    at.frames("frames", sequence.asked);
    at("fps", format.fps);
    at.size("size", format.width, format.height);
    at("encoding", format.encoding);
    at("channels", format.channels);
    at("backend", sequence.backend);
    at("made by", sequence.provenance);
}

template<class Visitor, Is<FrameRecord> R> void fields(Visitor& at, R& record) {
    at.constant("format", "isomotion frame 1");
    at("frame", record.frame);
    at.constant("state", "done");
    at("file", record.file);
    at("bytes", record.bytes);
    at("hash", record.hash);
    at("pixels", record.pixels);
    at("fingerprint", record.fingerprint);
    at("time", record.time);
    at.numbers("parameters", record.parameters);
    at.counts("rays", record.verdicts, render::verdict_names);
    at.where_known("pixels without colour", record.without_colour);
    at("evaluations", record.evaluations);
    at.counts("evaluations by kind", record.by_kind, render::ray_kind_names);
    at.counts("most of a pixel", record.most_of_a_pixel, render::ray_kind_names);
    at.counts("rays undecided", record.undecided, render::ray_kind_names);
    at.seconds("drawing seconds", record.drawing);
    at("made by", record.provenance);
    at.counts("proofs", record.proofs, render::proof_names);
    at.counts("audit", record.audit, audit_names);
}

void Writer::operator()(const char* key, const Provenance& value) {
    Writer inner;
    fields(inner, value);
    json_[key] = std::move(inner.json_);
}

void Reader::operator()(const char* key, Provenance& value) {
    Reader inner(table_.at(key).table());
    fields(inner, value);
}

template<class T> std::string written(const T& value) {
    Writer writer;
    fields(writer, value);
    return writer.text();
}

template<class T> T parsed(std::string_view text, const std::string& file) {
    T value;
    try {
        const auto document = base::Document::from_json(text, file);
        Reader reader(document.table());
        fields(reader, value);
    } catch (const base::InputError& error) {
        throw Error(Error::Code::file, fmt::format("{}; this is no manifest", error.what()));
    }
    return value;
}

} // namespace

std::string to_json(const Sequence& sequence) { return written(sequence); }
std::string to_json(const FrameRecord& record) { return written(record); }

Sequence parse_sequence(std::string_view text, const std::string& file) {
    return parsed<Sequence>(text, file);
}
FrameRecord parse_frame_record(std::string_view text, const std::string& file) {
    return parsed<FrameRecord>(text, file);
}

} // namespace isomotion::sequence

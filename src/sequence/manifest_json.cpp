#include "sequence/manifest_json.h"

#include <cmath>
#include <limits>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "animation/frame_range.h"

namespace isomotion::sequence {
namespace {

using Json = nlohmann::ordered_json; // keys as they were added

constexpr std::string_view sequence_format = "isomotion sequence 1";
constexpr std::string_view frame_format = "isomotion frame 1";

std::string text_of(const Json& json) {
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

Json json(const Provenance& provenance) {
    return {{"scene", provenance.scene},
            {"shaders", provenance.shaders},
            {"version", provenance.version},
            {"renderer", provenance.renderer},
            {"stage", provenance.stage}};
}

Provenance provenance_of(const Json& from) {
    return {from.at("scene"), from.at("shaders"), from.at("version"), from.at("renderer"),
            from.at("stage")};
}

// Counts under their names, as {"miss": 3, "hit": 4}.
template<class Counts, class Names> Json named(const Counts& counts, const Names& names) {
    Json all = Json::object();
    for (std::size_t k = 0; k < counts.size(); ++k) all[std::string(names[k])] = counts[k];
    return all;
}

template<class Counts, class Names> Counts counts_of(const Json& from, const Names& names) {
    Counts counts{};
    for (std::size_t k = 0; k < counts.size(); ++k) counts[k] = from.at(std::string(names[k]));
    return counts;
}

// JSON has no NaN and no infinity.
double number(const Json& from) {
    return from.is_null() ? std::numeric_limits<double>::quiet_NaN() : from.get<double>();
}

void expect_format(const Json& from, std::string_view wanted) {
    const std::string found = from.at("format");
    if (found != wanted)
        throw ManifestError(fmt::format("has format \"{}\", not \"{}\"", found, wanted));
}

template<class Read> auto parsed(std::string_view text, std::string_view format, Read&& read) {
    try {
        const Json json = Json::parse(text);
        expect_format(json, format);
        return read(json);
    } catch (const Json::exception& error) {
        throw ManifestError(fmt::format("is no manifest: {}", error.what()));
    } catch (const std::invalid_argument& error) {
        throw ManifestError(fmt::format("is no manifest: {}", error.what()));
    }
}

} // namespace

std::string to_json(const Sequence& sequence) {
    const SequenceFormat& format = sequence.format;
    return text_of({{"format", sequence_format},
                    {"title", sequence.title},
                    {"scene file", sequence.scene_file},
                    {"files", format.pattern},
                    {"frames", animation::frame_range(sequence.asked)},
                    {"fps", format.fps},
                    {"size", Json::array({format.width, format.height})},
                    {"encoding", format.encoding},
                    {"channels", format.channels},
                    {"backend", sequence.backend},
                    {"made by", json(sequence.provenance)}});
}

Sequence parse_sequence(std::string_view text) {
    return parsed(text, sequence_format, [](const Json& from) {
        Sequence sequence;
        sequence.title = from.at("title");
        sequence.scene_file = from.at("scene file");
        sequence.backend = from.at("backend");
        sequence.provenance = provenance_of(from.at("made by"));
        SequenceFormat& format = sequence.format;
        format.pattern = from.at("files");
        format.width = from.at("size").at(0);
        format.height = from.at("size").at(1);
        format.encoding = from.at("encoding");
        format.channels = from.at("channels").get<std::vector<std::string>>();
        format.fps = from.at("fps");
        const std::string frames = from.at("frames");
        if (!frames.empty()) sequence.asked = animation::parse_frame_range(frames);
        return sequence;
    });
}

std::string to_json(const FrameRecord& record) {
    Json parameters = Json::object();
    for (const auto& [name, value] : record.parameters) parameters[name] = value;
    Json all{{"format", frame_format},
             {"frame", record.frame},
             {"state", "done"},
             {"file", record.file},
             {"bytes", record.bytes},
             {"hash", record.hash},
             {"pixels", record.pixels},
             {"fingerprint", record.fingerprint},
             {"time", record.time},
             {"parameters", parameters},
             {"rays", named(record.verdicts, render::verdict_names)},
             {"evaluations", record.evaluations},
             {"drawing seconds", record.drawing},
             {"made by", json(record.provenance)}};
    if (record.proofs) all["proofs"] = named(*record.proofs, render::proof_names);
    return text_of(all);
}

FrameRecord parse_frame_record(std::string_view text) {
    return parsed(text, frame_format, [](const Json& from) {
        FrameRecord record;
        record.frame = from.at("frame");
        record.file = from.at("file");
        record.bytes = from.at("bytes");
        record.hash = from.at("hash");
        record.pixels = from.at("pixels");
        record.fingerprint = from.at("fingerprint");
        record.time = number(from.at("time"));
        for (const auto& [name, value] : from.at("parameters").items()) {
            record.parameters.emplace_back(name, number(value));
        }
        record.verdicts =
            counts_of<decltype(record.verdicts)>(from.at("rays"), render::verdict_names);
        record.evaluations = from.at("evaluations");
        record.drawing = number(from.at("drawing seconds"));
        record.provenance = provenance_of(from.at("made by"));
        if (const auto proofs = from.find("proofs"); proofs != from.end()) {
            record.proofs = counts_of<render::ProofCounts>(*proofs, render::proof_names);
        }
        return record;
    });
}

} // namespace isomotion::sequence

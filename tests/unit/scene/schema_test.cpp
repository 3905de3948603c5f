// The schema of scene files, held against what the reader knows.
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <nlohmann/json.hpp>

#include "scene/data_folder.h"
#include "scene/key_documents.h"
#include "scene/reading/load.h"
#include "scene/renamed_keys.h"

namespace isomotion::scene {
namespace {

using Json = nlohmann::json;
using Names = std::set<std::string>;

Json schema() {
    std::ifstream file(data_folder() / "animations" / "scene.schema.json");
    return Json::parse(file);
}

// A section with one key that nobody knows, in a scene that is else right.
struct Case {
    const char* section; // as renamed_key() has it
    const char* pointer; // where the schema has its keys
    const char* scene;   // {} is where the unknown key goes
};

constexpr const char* unknown = "zzqqzzqqzzqqzz";

const Case cases[] = {
    {"", "", "{} = 1\n[surface]\nformula = 'x'\n"},
    {"time", "/properties/time", "[surface]\nformula = 'x'\n[time]\n{} = 1\n"},
    {"surface", "/properties/surface", "[surface]\nformula = 'x'\n{} = 1\n"},
    {"surface.bounds", "/properties/surface/properties/bounds",
     "[surface]\nformula = 'x'\n[surface.bounds]\nsphere = 1\n{} = 1\n"},
    {"surface.transform", "/properties/surface/properties/transform",
     "[surface]\nformula = 'x'\nbounds = {{ sphere = 1 }}\n[surface.transform]\n{} = 1\n"},
    {"surfaces", "/properties/surfaces/items", "[[surfaces]]\nformula = 'x'\n{} = 1\n"},
    {"isolation", "/properties/isolation", "[surface]\nformula = 'x'\n[isolation]\n{} = 1\n"},
    {"camera", "/properties/camera", "[surface]\nformula = 'x'\n[camera]\n{} = 1\n"},
    {"lights", "/properties/lights/items",
     "[surface]\nformula = 'x'\n[[lights]]\ndirection = [1, 0, 0]\n{} = 1\n"},
    {"sections", "/properties/sections/items",
     "[surface]\nformula = 'x'\n[[sections]]\nsphere = 1\n{} = 1\n"},
    {"material.contours", "/properties/material/properties/contours",
     "[surface]\nformula = 'x'\n[material.contours]\nvalue = 'x'\nevery = 1\n{} = 1\n"},
    {"material", "/properties/material", "[surface]\nformula = 'x'\n[material]\n{} = 1\n"},
    {"material.colormap", "/properties/material/properties/colormap",
     "[surface]\nformula = 'x'\n[material.colormap]\nvalue = 'x'\nrange = [0, 1]\n{} = 1\n"},
    {"ground", "/properties/ground", "[surface]\nformula = 'x'\n[ground]\nheight = 0\n{} = 1\n"},
    {"fog", "/properties/fog", "[surface]\nformula = 'x'\n[fog]\ndensity = 1\n{} = 1\n"},
    {"ambient", "/properties/ambient",
     "[surface]\nformula = 'x'\n[ambient]\ntop = [1, 1, 1]\n{} = 1\n"},
    {"occlusion", "/properties/occlusion", "[surface]\nformula = 'x'\n[occlusion]\n{} = 1\n"},
    {"environment", "/properties/environment",
     "[surface]\nformula = 'x'\n[environment]\nmap = 'studio.exr'\n{} = 1\n"},
    {"output", "/properties/output", "[surface]\nformula = 'x'\n[output]\n{} = 1\n"},
    {"output.background", "/properties/output/properties/background/anyOf/2",
     "[surface]\nformula = 'x'\n[output.background]\ntop = [0, 0, 0]\nbottom = [0, 0, 0]\n{} = "
     "1\n"},
};

// What the reader says is known beside the key that isn't.
Names known_to_reader(const Case& section) {
    std::string words;
    try {
        load_text(fmt::format(fmt::runtime(section.scene), unknown), "scene.toml");
    } catch (const SceneError& error) {
        words = error.what();
    }
    const std::string before = std::string(unknown) + ": unknown key; known here: ";
    const std::size_t begin = words.find(before);
    if (begin == words.npos) {
        ADD_FAILURE() << section.section << ": " << words;
        return {};
    }
    std::istringstream list(words.substr(begin + before.size()));
    Names names;
    std::string line;
    std::getline(list, line);
    std::istringstream parts(line);
    for (std::string name; std::getline(parts >> std::ws, name, ',');) names.insert(name);
    return names;
}

// Former names count as the present ones.
Names known_to_schema(const Json& all, const Case& section) {
    Names names;
    const Json& table = all.at(Json::json_pointer(section.pointer));
    EXPECT_EQ(table.at("additionalProperties"), false) << section.section;
    for (const auto& [name, value] : table.at("properties").items()) {
        const bool is_listed = std::string_view(section.section) == "surfaces";
        const RenamedKey* key = renamed_key(is_listed ? "surface" : section.section, name);
        names.insert(key ? std::string(key->now) : name);
    }
    return names;
}

std::string text_of(const std::filesystem::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

// "cmake --build --preset release --target key_documents", then run it, writes both anew.
TEST(KeyDocuments, AreAsTheTablesSay) {
    const auto sections = key_sections();
    EXPECT_EQ(schema_text(sections), text_of(data_folder() / "animations" / "scene.schema.json"));
    const std::string page = text_of(ISOMOTION_SOURCE_DIR "/docs/scene-file.md");
    EXPECT_EQ(with_key_table(page, sections), page);
    EXPECT_THROW(with_key_table("no table", sections), std::invalid_argument);
}

TEST(KeyDocuments, PlainTextHasNoMarks) {
    EXPECT_EQ(plain_text("a [link](to.md#x) and `code`, \\|F\\| as *step limit*"),
              "a link and code, |F| as step limit");
    EXPECT_EQ(plain_text("2 * 3"), "2 * 3");
}

// A scene that says every key with a range reaches the ends of the range, and not beyond them.
TEST(KeyRanges, AreThoseThatTheReaderKeeps) {
    int checked = 0;
    for (const SectionDescription& section : key_sections()) {
        for (const KeyDescription& key : section.keys) {
            if (!key.least || section.name.find('.') != std::string::npos) continue;
            const bool is_glass = key.name == "depth" || key.name == "priority";
            const auto scene = [&](double value) {
                return fmt::format(
                    "[surface]\nformula = 'x'\nbounds = {{ sphere = 1 }}\n[{}]\n{}{} = "
                    "{}\n{}",
                    section.name, is_glass ? "transmission = 1\n" : "", key.name,
                    key.type == KeyType::integer ? fmt::format("{:.0f}", value)
                                                 : fmt::format("{:e}", value),
                    key.name == "poster" ? "[time]\nframes = 10000000\n" : "");
            };
            for (const double end : {*key.least, *key.most})
                EXPECT_NO_THROW(load_text(scene(end), "scene.toml")) << scene(end);
            const double step = key.type == KeyType::integer ? 1 : 0.5 * *key.most;
            EXPECT_THROW(load_text(scene(*key.most + step), "scene.toml"), SceneError) << key.name;
            EXPECT_THROW(load_text(scene(*key.least - 1), "scene.toml"), SceneError) << key.name;
            ++checked;
        }
    }
    EXPECT_GE(checked, 12);
}

TEST(Schema, HasTheKeysThatTheReaderKnowsAndNoOthers) {
    const Json all = schema();
    for (const Case& section : cases)
        EXPECT_EQ(known_to_schema(all, section), known_to_reader(section)) << section.section;
}

// A section that is added to the one is added here.
TEST(Schema, EverySectionIsHeldAgainstTheReader) {
    const Json all = schema();
    Names checked;
    for (const Case& section : cases) checked.insert(section.section);
    for (const auto& [name, value] : all.at("properties").items()) {
        const bool has_own_keys = value.contains("properties") || value.contains("items");
        if (!has_own_keys) continue;
        EXPECT_TRUE(checked.contains(name)) << name;
    }
}

TEST(Schema, HasTheLooksThatThereAre) {
    Names names{"none"};
    for (const std::string& look : look_names()) names.insert(look);
    EXPECT_EQ(schema().at("/properties/look/enum"_json_pointer).get<Names>(), names);
}

TEST(Schema, HasTheFormerNames) {
    const Json all = schema();
    const std::pair<const char*, const char*> former[] = {
        {"/properties/surface/properties", "placement"},
        {"/properties/material/properties", "paint"},
        {"/properties/material/properties", "inside"},
        {"/properties/occlusion/properties", "reach"},
        {"/definitions/array/properties", "outside"},
    };
    for (const auto& [pointer, name] : former)
        EXPECT_TRUE(all.at(Json::json_pointer(pointer)).contains(name)) << name;
}

// The reader refuses each of an array's keys where it has the wrong type, while an unknown one is a
// field.
TEST(Schema, HasTheKeysOfArraysFromFiles) {
    const Json all = schema();
    Names names;
    for (const auto& [name, value] : all.at("/definitions/array/properties"_json_pointer).items())
        names.insert(name);
    EXPECT_EQ(names, (Names{"count", "file", "first_file", "columns", "interpolation",
                            "extrapolate", "outside"}));
}

} // namespace
} // namespace isomotion::scene

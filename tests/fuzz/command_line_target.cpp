#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "animation/frame_range.h"
#include "app/commands.h"
#include "fuzz/targets.h"
#include "scene/reading/load.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::fuzz {
namespace {

constexpr const char* sphere = R"([surface]
formula = "x^2 + y^2 + z^2 - r^2"
bounds = { sphere = 2 }
[parameters]
r = { keys = [[0, 1], [1, 2]] }
[arrays.unused]
count = 2
[output]
size = [16, 16]
)";

// Nothing but what the program takes for a user's mistake is thrown.
template<class Action> void expect_mistake_or_none(const Action& action) {
    try {
        action();
    } catch (const CLI::ParseError&) {
    } catch (const std::invalid_argument&) {
    } catch (const scene::SceneError&) {
    }
}

} // namespace

void command_line(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    expect_mistake_or_none([&] {
        CLI::App app("isomotion", "isomotion");
        app::Action chosen;
        app::add_commands(app, chosen);
        app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
        if (!chosen) throw Violation("a command line that is right asks for nothing");
    });
    for (const std::string& word : words) {
        expect_mistake_or_none([&] {
            const std::vector<int> frames = animation::parse_frame_range(word);
            if (animation::parse_frame_range(animation::frame_range(frames)).size() !=
                frames.size())
                throw Violation("a range of frames, written shorter, has others");
        });
        expect_mistake_or_none([&] {
            const auto name = sequence::SequenceName::parse(word);
            if (name.holds_many() && name.path(7) == name.path(8))
                throw Violation("two frames of one name");
        });
        expect_mistake_or_none([&] { scene::load_text(sphere, "sphere.toml", {word}); });
    }
}

} // namespace isomotion::fuzz

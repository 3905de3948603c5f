#include "render/stage.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <stdexcept>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "gpu/compute.h"

namespace isomotion::render {
namespace {

constexpr std::array stage_names = {
    std::pair{StageChoice::fragment, std::string_view{"fragment"}},
    std::pair{StageChoice::compute, std::string_view{"compute"}},
    std::pair{StageChoice::automatic, std::string_view{"auto"}},
};

// GPUs made for data centres alone, which run fragment shaders on a few of their processors: of an
// H100's 66 pairs of them two can (NVIDIA's description of the Hopper architecture). The same
// arithmetic was measured to run 30 times faster on an H200 in compute shaders. Later ones are
// taken to be alike; a wrong guess costs little, as both stages run the same code.
constexpr std::array few_fragment_processors = {"H100", "H200", "H800", "H20",   "GH200",
                                                "B100", "B200", "B300", "GB200", "GB300"};

// Whether a word of the renderer's name is that of such a GPU: "NVIDIA H200/PCIe/SSE2",
// "NVIDIA H100 80GB HBM3".
bool draws_on_few_processors(std::string_view renderer) {
    std::string word;
    const auto known = [&] {
        return std::ranges::find(few_fragment_processors, std::string_view(word)) !=
               few_fragment_processors.end();
    };
    for (const char c : renderer) {
        if (std::isalnum(static_cast<unsigned char>(c))) {
            word += c;
            continue;
        }
        if (known()) return true;
        word.clear();
    }
    return known();
}

} // namespace

StageChoice parse_stage(std::string_view text) {
    std::string known;
    for (const auto& [choice, name] : stage_names) {
        if (text == name) return choice;
        known += fmt::format("{}{}", known.empty() ? "" : ", ", name);
    }
    throw std::invalid_argument(
        fmt::format("--stage: there is no stage '{}'; known: {}", text, known));
}

std::string_view name(shader::Stage stage) {
    return stage == shader::Stage::fragment ? "fragment" : "compute";
}

shader::Stage choose_stage(StageChoice choice, const gpu::ContextInfo& info) {
    switch (choice) {
    case StageChoice::fragment:
        break;
    case StageChoice::compute:
        gpu::expect_compute(info, "--stage compute");
        return shader::Stage::compute;
    case StageChoice::automatic:
        if (!info.software && gpu::has_compute(info) && draws_on_few_processors(info.renderer)) {
            return shader::Stage::compute;
        }
    }
    return shader::Stage::fragment;
}

} // namespace isomotion::render

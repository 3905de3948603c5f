#include "shader/tape_text.h"

#include <algorithm>
#include <stdexcept>
#include <string>

#include <fmt/format.h>

#include "formula/glsl/glsl_interval.h"
#include "shader/loop_limit.h"
#include "shader/pass.h"
#include "shader/shader_files.h"
#include "shader/shader_text.h"

namespace isomotion::shader {
namespace {

std::string number_of(FieldFunction function) { return std::to_string(int(function)); }

formula::IntervalSignature signature_of(FieldFunction function) {
    const auto on_numbers = [](const formula::GlslSignature& of) {
        return formula::IntervalSignature{of.head, of.inputs, of.result, {}};
    };
    switch (function) {
    case FieldFunction::value:
        return on_numbers(formula::value_signature());
    case FieldFunction::directional:
        return on_numbers(formula::directional_signature());
    case FieldFunction::gradient:
        return on_numbers(formula::gradient_signature());
    case FieldFunction::value_interval:
        return formula::value_interval_signature();
    case FieldFunction::directional_interval:
        return formula::directional_interval_signature();
    case FieldFunction::gradient_interval:
        return formula::gradient_interval_signature();
    case FieldFunction::rough:
        return formula::rough_signature();
    case FieldFunction::breaks:
        return formula::breaks_signature();
    case FieldFunction::hessian_interval:
        break;
    }
    throw std::logic_error("second derivatives have no tape");
}

// Where its spans begin, in GLSL.
std::string spans_of(FieldFunction function) {
    const int place = int(function);
    return fmt::format("int(tape_block[{}].{})", tape_vectors_of_place + place / 4,
                       "xyzw"[place % 4]);
}

// The function itself: puts the inputs into registers, runs the tape, and takes the outputs.
std::string glsl_of(FieldFunction function, const formula::TapeFunctions::Function& tape) {
    const formula::IntervalSignature signature = signature_of(function);
    const bool boxes = is_on_intervals(function);
    const std::string registers = boxes ? "tape_intervals" : "tape_numbers";
    std::string text = signature.head + " {\n";
    for (std::size_t k = 0; k < signature.inputs.size() && int(k) < tape.inputs; ++k)
        text += fmt::format("    {}[{}] = {};\n", registers, k, signature.inputs[k]);
    const int place = int(function);
    const bool decorated = function == FieldFunction::rough;
    if (decorated) text += "    tape_is_rough = false;\n";
    const auto spans =
        fmt::format("int(tape_block[{}].{})", tape_vectors_of_place + place / 4, "xyzw"[place % 4]);
    text += fmt::format("    run_tape_{}({});\n", place,
                        boxes ? fmt::format("tape_over({}, x, y, z)", spans)
                              : fmt::format("tape_at({}, p)", spans));
    std::string outputs;
    for (int o = 0; o < tape.outputs; ++o) {
        const std::string output = fmt::format("{}[{}]", registers, tape.inputs + o);
        if (signature.result.empty())
            text += fmt::format("    {} = {};\n", signature.outputs[std::size_t(o)], output);
        outputs += (o == 0 ? "" : ", ") + output;
    }
    if (decorated)
        outputs += ", mix(vec2(0.0), vec2(-IM_INFINITY, IM_INFINITY), bvec2(tape_is_rough))";
    if (!signature.result.empty())
        text += fmt::format("    return {}({});\n", signature.result, outputs);
    return text + "}\n";
}

// The gradient by slopes along the axes: a tape of all three keeps many values at a time.
std::string along_axes(FieldFunction function) {
    const bool boxes = is_on_intervals(function);
    const formula::IntervalSignature signature = signature_of(function);
    const std::string type = boxes ? "vec2" : "float";
    const std::string slope =
        boxes ? "field_directional_interval(x, y, z, vec2(d.x), vec2(d.y), vec2(d.z)).zw"
              : "field_directional(p, d).y";
    // Software renderers run the body of a for once more.
    return fmt::format("{0} {{\n"
                       "    {1} slopes[3];\n"
                       "    int axis = 0;\n"
                       "    do {{\n"
                       "        vec3 d = vec3(axis == 0, axis == 1, axis == 2);\n"
                       "        slopes[axis] = {2};\n"
                       "        ++axis;\n"
                       "    }} while (axis < 3);\n"
                       "    {3}\n}}\n",
                       signature.head, type, slope,
                       boxes ? "gx = slopes[0]; gy = slopes[1]; gz = slopes[2];"
                             : "return vec3(slopes[0], slopes[1], slopes[2]);");
}

} // namespace

std::shared_ptr<const FieldTapes> FieldTapes::of(const formula::Field& field, int parameters,
                                                 std::vector<formula::ElementRange> ranges) {
    // The part of a draw's turns that three slopes may take. Longer ones are taken by one tape of
    // all: that of 12,000 sines of x and y takes a third of the turns.
    constexpr double part_of_normals = 0.5;
    // Of one function: software renderers end a loop after 65,536 turns.
    constexpr std::size_t longest = 65'536 * formula::tape_unrolled;
    const formula::EnclosurePrograms& over_boxes = formula::enclosure_programs(field);
    // Its decoration comes of running it.
    formula::Program enclosure_of_rough = over_boxes.rough;
    enclosure_of_rough.outputs.resize(1);
    using enum FieldFunction;
    using enum formula::TapeNumbers;
    // Slopes last: values that these need stay next to them (formula/tape/tape.cpp).
    const std::vector<std::vector<std::pair<FieldFunction, formula::TapeRequest>>> groups{
        {{value, {field.value, floats}},
         {gradient, {field.gradient, floats, 0, 3}},
         {directional, {field.directional, floats, 1, 1}}},
        {{value_interval, {over_boxes.value, intervals}},
         {rough, {enclosure_of_rough, decorated}},
         {breaks, {over_boxes.breaks, intervals, 0}},
         {directional_interval, {over_boxes.directional, intervals, 1, 1}}}};
    FieldTapes tapes(formula::ElementParameters(parameters, field.packing, std::move(ranges)));
    const auto made = [&](const auto& group, bool with_gradient) {
        std::vector<formula::TapeRequest> requests;
        for (const auto& of : group) {
            if (of.first == gradient && !with_gradient) continue;
            auto program = formula::unrolled(of.second.program, tapes.elements_, longest);
            if (!program) return std::optional<formula::TapeFunctions>();
            requests.push_back(of.second);
            requests.back().program = std::move(*program);
        }
        return formula::TapeFunctions::of(requests);
    };
    for (const auto& group : groups) {
        // Where jumps are walls, a normal is no slope along a ray. Elsewhere slopes along the axes
        // keep fewer values at a time.
        bool with_gradient = group.front().first == value && field.wall_distance != 0;
        auto functions = made(group, with_gradient);
        if (!functions) return nullptr;
        const int turns = (*functions)[functions->size() - 1].turns; // of a slope along a ray
        if (group.front().first == value && !with_gradient &&
            3 * turns > part_of_normals * loop_iterations_per_pass) {
            if (auto joint = made(group, true)) {
                functions = std::move(joint);
                with_gradient = true;
            }
        }
        for (const auto& of : group) {
            if (of.first != gradient || with_gradient) tapes.functions_.push_back(of.first);
        }
        tapes.groups_.push_back(std::move(*functions));
    }
    return std::make_shared<const FieldTapes>(std::move(tapes));
}

const formula::TapeFunctions::Function& FieldTapes::function(FieldFunction of) const {
    auto k = std::size_t(std::ranges::find(functions_, of) - functions_.begin());
    if (k < groups_[0].size()) return groups_[0][k];
    k -= groups_[0].size();
    if (k >= groups_[1].size()) throw std::logic_error("a function without a tape");
    return groups_[1][k];
}

std::vector<bool> FieldTapes::are_run(const Passes& passes) const {
    std::vector<bool> all;
    for (const FieldFunction function : functions_) {
        const std::string run = fmt::format("run_tape_{}({}", int(function),
                                            is_on_intervals(function) ? "tape_over" : "");
        all.push_back(std::ranges::any_of(passes.list, [&](const Pass& pass) {
            return pass.text.find(run) != std::string::npos;
        }));
    }
    return all;
}

bool FieldTapes::chooses() const {
    return std::ranges::any_of(groups_, &formula::TapeFunctions::chooses);
}

formula::Cost FieldTapes::cost(const std::vector<FieldFunction>& functions) const {
    // Measured on llvmpipe: an instruction takes as long as some dozen operations that are
    // compiled.
    constexpr double on_numbers = 12, on_intervals = 30;
    constexpr int usual = 16; // turns in a cell
    formula::Cost cost;
    cost.iterations = 2; // on the way past free cells
    for (const FieldFunction of : functions) {
        // Breaks are looked for at up to three places of one step, gradients along three axes.
        const int runs = of == FieldFunction::breaks || run_for(of) != of ? 3 : 1;
        const auto& tape = function(run_for(of));
        const int turns = runs * tape.turns;
        cost.iterations += turns;
        // Where others are called, loops of noise's bounds end at once.
        constexpr int at_once = 3;
        if (is_on_intervals(of))
            cost.iterations += runs * tape.noises * turns_of_noise_bounds +
                               at_once * tape.operations.orders_of_noise() * turns;
        cost.operations += (is_on_intervals(of) ? on_intervals : on_numbers) *
                           formula::tape_unrolled * (chooses() ? std::min(turns, usual) : turns);
    }
    return cost;
}

FieldFunction FieldTapes::run_for(FieldFunction of) const {
    if (std::ranges::find(functions_, of) != functions_.end()) return of;
    return of == FieldFunction::gradient ? FieldFunction::directional
                                         : FieldFunction::directional_interval;
}

void add_tapes(ShaderText& text, const FieldTapes& tapes,
               const std::vector<FieldFunction>& wanted) {
    std::set<FieldFunction> functions;
    for (const FieldFunction function : wanted) functions.insert(tapes.run_for(function));
    std::set<std::string> kernels, interval_kernels;
    int numbers = 0, intervals = 0; // registers
    for (const FieldFunction function : functions) {
        const formula::TapeFunctions::Function& tape = tapes.function(function);
        const bool boxes = is_on_intervals(function);
        (boxes ? interval_kernels : kernels).merge(tape.operations.kernels());
        int& registers = boxes ? intervals : numbers;
        registers = std::max(registers, tape.registers);
    }
    for (const auto& kernel : kernel_files(kernels)) text.file(kernel);
    if (intervals > 0) {
        for (const auto& kernel : interval_files(interval_kernels)) text.file(kernel);
    }
    text.file("tape/cells.glsl");
    text.define(Feature::tape_of_rays, spans_of(FieldFunction::directional));
    for (const bool boxes : {false, true}) {
        const int registers = boxes ? intervals : numbers;
        if (registers == 0) continue;
        const std::string number = boxes ? "vec2" : "float";
        const std::string all = boxes ? "tape_intervals" : "tape_numbers";
        text.generated("registers of tapes", fmt::format("{} {}[{}];\n", number, all, registers));
        for (const FieldFunction function : functions) {
            if (is_on_intervals(function) != boxes) continue;
            const formula::TapeFunctions::Function& tape = tapes.function(function);
            const std::string name = "tape_" + number_of(function);
            text.generated("operations of tapes", tape.operations.glsl(name));
            text.instance("tape/run.glsl",
                          {{"TAPE_RUN", "run_" + name},
                           {"TAPE_OPERANDS", "operands_of_" + name},
                           {"TAPE_STEP", "step_of_" + name},
                           {"TAPE_APPLY", name + "_apply"},
                           {"TAPE_CALL", name + "_call"},
                           {"TAPE_NUMBER", number},
                           {"TAPE_REGISTERS", all},
                           {"TAPE_LITERAL", boxes ? "tape_interval" : "tape_float"},
                           {"TAPE_CHOOSE", boxes ? "IM_SELECT2" : "IM_SELECT"},
                           {"TAPE_MASK", std::to_string(registers - 1) + "u"}},
                          tape.operations.has_calls() ? std::vector{Feature::calls}
                                                      : std::vector<Feature>{});
            text.generated("runs tapes", glsl_of(function, tape));
        }
    }
    for (const FieldFunction function : wanted) {
        if (!functions.contains(function)) text.generated("along each axis", along_axes(function));
    }
}

void define_signs_in_free_tapes(ShaderText& text, const FieldTapes& tapes) {
    text.define(Feature::signs_in_free_cells);
    text.define(Feature::tape_inputs, tapes.function(FieldFunction::directional).inputs);
    text.define(Feature::run_tape_of_rays,
                fmt::format("run_tape_{}", int(FieldFunction::directional)));
}

} // namespace isomotion::shader

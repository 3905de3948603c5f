#include "formula/tape/tape_cells.h"

#include <algorithm>
#include <bit>
#include <limits>
#include <memory>

#include "base/workers.h"

namespace isomotion::formula {
namespace {

constexpr int most_levels = 5;
// Shorter tapes are not worth a look at eight parts.
constexpr std::size_t short_enough = 24;
// A cell has its own words if they are fewer than the larger cell's by this factor.
constexpr double shorter = 0.75;
// The part of a cell that its tape holds around it: as in shaders/tape/cells.glsl.
constexpr double around_for_points = 0.0625, around_for_boxes = 0.5;

bool chooses(const TapeStep& step) {
    switch (step.op) {
    case Op::abs:
    case Op::sign:
    case Op::floor:
    case Op::min:
    case Op::max:
    case Op::select:
        return true;
    default:
        return false;
    }
}

int cells_along(int level) { return 1 << level; }
std::size_t cells_of(int level) { return std::size_t(1) << (3 * level); }
// Before a level's cells: the whole space's tape and those of coarser levels.
std::size_t first_of(int level) { return 1 + (cells_of(level) - 1) / 7; }

// The cell of the level before that holds a cell.
std::size_t parent_of(std::size_t cell, int level) {
    if (level == 0) return 0;
    const auto n = std::size_t(cells_along(level));
    const std::size_t x = cell % n / 2, y = cell / n % n / 2, z = cell / (n * n) / 2;
    return (z * (n / 2) + y) * (n / 2) + x;
}

// A tape, and where the instructions begin that a shader runs for it: its own, or those of a longer
// one, of so many steps.
struct Placed {
    std::shared_ptr<const Tape> tape;
    std::uint32_t first = 0, count = 0;
    std::size_t placed_steps = 0;
};

class Maker {
public:
    Maker(const std::array<Interval, 3>& box, const TapeLimits& limits, TapeCells& cells)
        : box_(box)
        , limits_(limits)
        , cells_(cells) {}

    // Returns the spans of one function.
    std::vector<Placed> run(const TapeFunction& function, std::span<const float> parameters,
                            double steps) {
        const auto whole = std::make_shared<const Tape>(function.whole(parameters));
        const TapeWords words =
            words_of(*whole, function.operations(), function.inputs()).value();
        std::vector<Placed> all{place(whole, words)};
        if (std::ranges::none_of(whole->steps, chooses)) return all;
        double looked_at = 0;
        for (int level = 0; level <= most_levels; ++level) {
            const auto parent = [&](std::size_t cell) -> const Placed& {
                return all[level == 0 ? 0 : first_of(level - 1) + parent_of(cell, level)];
            };
            double cost = 0;
            for (std::size_t cell = 0; cell < cells_of(level); ++cell) {
                if (worth_a_look(parent(cell))) cost += double(parent(cell).tape->steps.size());
            }
            looked_at += cost;
            if (cost == 0 || looked_at > steps) break;
            std::vector<Placed> made = level_of(function, level, parent);
            for (Placed& coarser : all) coarser.tape.reset(); // nobody asks for them again
            all.insert(all.end(), made.begin(), made.end());
        }
        return all;
    }

private:
    static bool worth_a_look(const Placed& placed) {
        return placed.tape->steps.size() > short_enough;
    }

    template<class Parent>
    std::vector<Placed> level_of(const TapeFunction& function, int level, const Parent& parent) {
        struct Made {
            std::shared_ptr<const Tape> tape;
            std::optional<TapeWords> words;
        };
        std::vector<Made> made(cells_of(level));
        base::share({made.size(), limits_.threads}, [&] {
            return [&, specialise = Specialiser()](std::size_t cell) mutable {
                const Placed& from = parent(cell);
                if (!worth_a_look(from)) return;
                auto tape = std::make_shared<const Tape>(
                    specialise(*from.tape, inputs_in(cell, level, function)));
                if (double(tape->steps.size()) <= shorter * double(from.placed_steps))
                    made[cell].words = words_of(*tape, function.operations(), function.inputs(),
                                                function.registers());
                made[cell].tape = std::move(tape);
            };
        });
        std::vector<Placed> placed;
        placed.reserve(made.size());
        for (std::size_t cell = 0; cell < made.size(); ++cell) {
            Placed& next = placed.emplace_back(parent(cell));
            const auto& [tape, words] = made[cell];
            if (tape) next.tape = tape;
            if (!words) continue;
            const std::size_t count = words->words.size() / 2;
            if (cells_.words.size() / 2 + count <= limits_.instructions)
                next = place(tape, *words);
        }
        return placed;
    }

    Placed place(std::shared_ptr<const Tape> tape, const TapeWords& words) {
        const auto first = std::uint32_t(cells_.words.size() / 2);
        cells_.words.insert(cells_.words.end(), words.words.begin(), words.words.end());
        const std::size_t steps = tape->steps.size();
        return {std::move(tape), first, std::uint32_t(words.words.size() / 2), steps};
    }

    // With what is around the cell, and what shaders lose when they look for it.
    std::vector<Interval> inputs_in(std::size_t cell, int level,
                                    const TapeFunction& function) const {
        const bool points = function.operations().numbers() == TapeNumbers::floats;
        const double around = points ? around_for_points : around_for_boxes;
        const auto n = std::size_t(cells_along(level));
        const std::array<std::size_t, 3> at{cell % n, cell / n % n, cell / (n * n)};
        // Directions are finite.
        constexpr double largest = std::numeric_limits<float>::max();
        std::vector<Interval> bounds(std::size_t(function.inputs()), Interval(-largest, largest));
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = box_[k].hi - box_[k].lo, side = size / double(n);
            const double slack = 1e-6 * (size + magnitude(box_[k]));
            bounds[k] = {box_[k].lo + (double(at[k]) - around) * side - slack,
                         box_[k].lo + (double(at[k]) + 1 + around) * side + slack};
        }
        return bounds;
    }

    const std::array<Interval, 3>& box_;
    const TapeLimits& limits_;
    TapeCells& cells_;
};

std::vector<Interval> on_doubles(std::span<const float> parameters) {
    return {parameters.begin(), parameters.end()};
}

int inputs_of(const Program& program) {
    int inputs = 3;
    for (const Instruction& now : program.instructions) {
        if (now.kind == Instruction::Kind::operation && now.op == Op::input && now.index >= 3)
            inputs = 6;
    }
    return inputs;
}

} // namespace

std::optional<TapeFunction> TapeFunction::of(Program program, TapeNumbers numbers) {
    int parameters = 0;
    for (const Instruction& now : program.instructions) {
        if (now.op == Op::parameter) parameters = std::max(parameters, now.index + 1);
    }
    // Any values do: the tape's shape does not depend on them.
    const std::vector<Interval> any(std::size_t(parameters), Interval(0.3));
    const auto tape = tape_of(program, any);
    if (!tape) return {};
    const int inputs = inputs_of(program);
    if (!words_of(*tape, TapeOperations(*tape, numbers), inputs)) return {};
    return TapeFunction(std::move(program), numbers, inputs, *tape);
}

TapeFunction::TapeFunction(Program program, TapeNumbers numbers, int inputs, const Tape& tape)
    : program_(std::move(program))
    , inputs_(inputs)
    , operations_(tape, numbers) {
    const TapeWords words = words_of(tape, operations_, inputs).value();
    turns_ = words.turns;
    registers_ = int(std::bit_ceil(unsigned(words.registers)));
}

Tape TapeFunction::whole(std::span<const float> parameters) const {
    return tape_of(program_, on_doubles(parameters)).value();
}

int TapeCells::spans_of_a_function() const { return int(first_of(levels + 1)); }

TapeCells tape_cells(std::span<const std::reference_wrapper<const TapeFunction>> functions,
                     std::span<const float> parameters,
                     const std::array<Interval, 3>& box, const TapeLimits& limits) {
    TapeCells cells;
    for (std::size_t k = 0; k < 3; ++k) {
        cells.low[k] = box[k].lo;
        cells.size[k] = box[k].hi - box[k].lo;
    }
    std::vector<std::vector<Placed>> all;
    for (const TapeFunction& function : functions) {
        all.push_back(Maker(box, limits, cells)
                          .run(function, parameters, limits.steps / double(functions.size())));
        while (all.back().size() > first_of(cells.levels + 1)) ++cells.levels;
    }
    // Where a function has no such level, its finest one serves.
    const auto add = [&](const std::vector<Placed>& placed, int level, std::size_t cell) {
        for (; level >= 0 && first_of(level) >= placed.size(); --level)
            cell = parent_of(cell, level);
        const Placed& found = placed[level < 0 ? 0 : first_of(level) + cell];
        cells.spans.push_back(found.first);
        cells.spans.push_back(found.count);
    };
    for (const std::vector<Placed>& placed : all) {
        add(placed, -1, 0);
        for (int level = 0; level <= cells.levels; ++level) {
            for (std::size_t cell = 0; cell < cells_of(level); ++cell) add(placed, level, cell);
        }
    }
    return cells;
}

} // namespace isomotion::formula

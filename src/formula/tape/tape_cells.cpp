#include "formula/tape/tape_cells.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <random>
#include <stdexcept>

#include "base/workers.h"
#include "formula/graph/functions.h"
#include "formula/tape/tape_order.h"

namespace isomotion::formula {
namespace {

constexpr int most_levels = 5;
// Cells of this level are shared among threads.
constexpr int shared_level = 2;
// Shorter tapes are not worth a look at eight parts.
constexpr std::size_t short_enough = 24;
// A cell has its own words if its tape is shorter than the one they are of by this factor.
constexpr double shorter = 0.6;
// The part of a cell that its tape holds around it: as in shaders/tape/cells.glsl.
constexpr double around_for_points = 0.0625, around_for_boxes = 0.25;

// The function's part of a tape of all, in an order of its own if it has one. F, the first output
// of all, is ordered with slopes alone, too, so that each of them stands behind its value.
Tape tape_of(const TapeFunctions::Function& function, const Tape& all) {
    Tape own = part_of(all, function.first_output, function.outputs);
    if (!function.has_own_order) return own;
    std::vector<bool> is_slope(std::size_t(function.outputs), false);
    std::fill_n(is_slope.begin() + function.values, function.slopes, true);
    const bool is_without_f = function.values == 0 && function.slopes == function.outputs;
    if (!is_without_f) return in_short_order(own, is_slope);
    Tape with_f = all;
    with_f.outputs = own.outputs;
    std::copy_n(all.outputs.begin() + function.first_output, function.outputs,
                with_f.outputs.begin());
    with_f.outputs.insert(with_f.outputs.begin(), all.outputs.front());
    is_slope.insert(is_slope.begin(), false);
    const Tape ordered = in_short_order(part_of(with_f, 0, 1 + function.outputs), is_slope);
    return part_of(ordered, 1, function.outputs);
}

bool decides(const TapeStep& step) {
    return has_steps(step.op) || step.op == Op::abs || step.op == Op::min || step.op == Op::max ||
           step.op == Op::select;
}

std::size_t cells_of(int level) { return std::size_t(1) << (3 * level); }
// Before a level's cells: the whole space's tape and those of coarser levels.
std::size_t first_of(int level) { return 1 + (cells_of(level) - 1) / 7; }

struct Cell {
    int level = 0;
    std::array<int, 3> at{};

    std::size_t place() const {
        const auto n = std::size_t(1) << level;
        return first_of(level) + (std::size_t(at[2]) * n + std::size_t(at[1])) * n +
               std::size_t(at[0]);
    }
    Cell part(int k) const {
        return {level + 1, {2 * at[0] + (k & 1), 2 * at[1] + (k >> 1 & 1), 2 * at[2] + (k >> 2)}};
    }
};

// The words of one thread's part of the cells; number 0 has the whole space's and those of coarse
// cells.
using Owner = std::size_t;

// Where the instructions of a function's tape lie, how many steps the tape has, and whether it is
// of a cell that holds no root.
struct Span {
    Owner owner = 0;
    std::uint32_t first = 0, count = 0;
    std::size_t steps = 0;
    std::uint32_t notes = 0; // TapeCells::free and so on, or 0
};
using Spans = std::vector<Span>; // of each function of a group

// A tape for a cell, and the words that a shader runs there.
struct Placed {
    Tape tape;
    Spans spans;
};

// Goes through cells and makes words.
class Maker {
public:
    // `finest`: the level of the finest cells.
    Maker(const TapeFunctions& functions, std::span<const char> are_run,
          const std::array<Interval, 3>& box, Owner owner, int finest)
        : functions_(functions)
        , are_run_(are_run)
        , box_(box)
        , owner_(owner)
        , finest_(finest) {}

    std::vector<std::uint32_t> words;
    std::size_t room = std::numeric_limits<std::size_t>::max(); // for words

    // Words of the tape where it is so much shorter than that of `longer`, else those.
    Spans place(const Tape& tape, const Spans& longer) {
        Spans spans = longer;
        for (std::size_t k = 0; k < functions_.size(); ++k) {
            const TapeFunctions::Function& of = functions_[k];
            if (!are_run_[k]) continue;
            if (double(tape.steps.size()) > shorter * double(longer[k].steps)) continue;
            const auto made = words_of(tape_of(of, tape), of.operations, of.inputs, of.registers);
            if (!made || words.size() + made->words.size() > room) continue;
            spans[k] = {owner_, std::uint32_t(words.size() / 2),
                        std::uint32_t(made->words.size() / 2), tape.steps.size()};
            words.insert(words.end(), made->words.begin(), made->words.end());
        }
        return spans;
    }

    // Visits a cell and its parts down to the level `last`: visit(cell, placed). `from` is of the
    // cell that holds it. Short tapes stay as they are.
    template<class Visit>
    void descend(const Cell& cell, const Placed& from, int last, const Visit& visit) {
        if (from.tape.steps.size() <= short_enough) return;
        Placed& here = open_[std::size_t(cell.level)];
        specialise_(from.tape, inputs_in(cell), here.tape);
        const Interval f = specialise_.bounds_of(0);
        const bool is_free = f.lo > 0 || f.hi < 0;
        if (is_free && !functions_.on_points()) know_values(f, here.tape);
        // Points look for their tape in the finest cells alone.
        const bool serves = !functions_.on_points() || cell.level >= finest_ ||
                            here.tape.steps.size() <= short_enough;
        here.spans = serves && !(is_free && functions_.on_points()) ? place(here.tape, from.spans)
                                                                    : from.spans;
        for (Span& span : here.spans) {
            if (is_free)
                span.notes = TapeCells::free + (f.hi < 0 ? TapeCells::negative : 0) +
                             std::uint32_t(cell.level) * TapeCells::level_unit;
        }
        visit(cell, here);
        for (int k = 0; !is_free && cell.level < last && k < 8; ++k)
            descend(cell.part(k), here, last, visit);
    }

    // The steps looked at on each level, about, by cells at random.
    std::vector<double> work_of_levels(const Tape& whole) {
        constexpr int samples = 24;
        std::mt19937 random(1);
        std::vector<double> work(most_levels + 1, 0);
        std::array<Tape, 2> tapes;
        for (int sample = 0; sample < samples; ++sample) {
            const Tape* from = &whole;
            Cell cell;
            while (cell.level <= most_levels && from->steps.size() > short_enough) {
                work[std::size_t(cell.level)] +=
                    double(cells_of(cell.level)) / samples * double(from->steps.size());
                Tape& here = tapes[std::size_t(cell.level % 2)];
                specialise_(*from, inputs_in(cell), here);
                if (specialise_.bounds_of(0).lo > 0 || specialise_.bounds_of(0).hi < 0) break;
                from = &here;
                cell = cell.part(int(random() % 8));
            }
        }
        return work;
    }

private:
    // Over boxes in which F keeps off 0, its bounds are all that anybody asks for.
    void know_values(Interval f, Tape& tape) const {
        const auto constant = [&](Interval value) {
            tape.steps.push_back({.value = value});
            return int(tape.steps.size()) - 1;
        };
        const int bounds = constant(f), any = constant(Interval::entire());
        for (std::size_t k = 0; k < functions_.size(); ++k) {
            const TapeFunctions::Function& of = functions_[k];
            for (int o = 0; o < of.values + of.slopes; ++o)
                tape.outputs[std::size_t(of.first_output + o)] = o < of.values ? bounds : any;
        }
        tape = part_of(tape, 0, int(tape.outputs.size()));
    }

    // With what is around the cell, and what shaders lose when they look for it.
    std::array<Interval, 6> inputs_in(const Cell& cell) const {
        const double around = functions_.on_points() ? around_for_points : around_for_boxes;
        constexpr double largest = std::numeric_limits<float>::max();
        std::array<Interval, 6> bounds;
        bounds.fill({-largest, largest}); // directions are finite
        for (std::size_t k = 0; k < 3; ++k) {
            const double size = box_[k].hi - box_[k].lo;
            const double side = size / double(std::size_t(1) << cell.level);
            const double slack = 1e-6 * (size + magnitude(box_[k]));
            bounds[k] = {box_[k].lo + (cell.at[k] - around) * side - slack,
                         box_[k].lo + (cell.at[k] + 1 + around) * side + slack};
        }
        return bounds;
    }

    const TapeFunctions& functions_;
    std::span<const char> are_run_;
    const std::array<Interval, 3>& box_;
    Owner owner_;
    int finest_;
    Specialiser specialise_;
    std::array<Placed, most_levels + 1> open_; // the cells that hold the one visited
};

// The cells of one group of functions.
class GroupCells {
public:
    GroupCells(const TapeFunctions& functions, std::vector<char> are_run,
               std::span<const float> parameters, const std::array<Interval, 3>& box,
               const TapeLimits& limits)
        : functions_(functions)
        , are_run_(std::move(are_run)) {
        Placed whole{functions.whole(parameters), {}};
        levels_ = levels_within(whole.tape, box, limits);
        Maker maker(functions, are_run_, box, 0, levels_);
        constexpr std::size_t longest = std::numeric_limits<std::size_t>::max();
        whole.spans = maker.place(whole.tape, Spans(functions.size(), {0, 0, 0, longest}));
        for (std::size_t k = 0; k < functions.size(); ++k) {
            if (are_run_[k] && whole.spans[k].count == 0)
                throw std::length_error("the formula keeps too many values at a time");
        }
        spans_.resize(first_of(levels_ + 1));
        spans_[0] = whole.spans;
        std::vector<std::pair<Cell, Placed>> tops; // that threads go on from
        const int shared = std::min(shared_level, levels_);
        if (levels_ >= 0) {
            maker.descend({}, whole, shared, [&](const Cell& cell, const Placed& placed) {
                spans_[cell.place()] = placed.spans;
                if (cell.level == shared && placed.spans[0].notes == 0)
                    tops.emplace_back(cell, placed);
            });
        }
        words_.push_back(std::move(maker.words));
        if (levels_ > shared) go_on(tops, box, limits);
        inherit({}, spans_[0]);
    }

    int levels() const { return levels_; } // the finest; -1 without cells

    // Adds the words, and for each function its spans down to a level of all groups.
    void add_to(TapeCells& cells) const {
        std::vector<std::uint32_t> begins;
        std::size_t total = cells.words.size();
        for (const std::vector<std::uint32_t>& words : words_) total += words.size();
        cells.words.reserve(total);
        for (const std::vector<std::uint32_t>& words : words_) {
            begins.push_back(std::uint32_t(cells.words.size() / 2));
            cells.words.insert(cells.words.end(), words.begin(), words.end());
        }
        for (std::size_t k = 0; k < functions_.size(); ++k) {
            const auto add = [&](const Spans& spans) {
                cells.spans.push_back(begins[spans[k].owner] + spans[k].first);
                cells.spans.push_back(spans[k].count +
                                      (functions_.on_points() ? spans[k].notes : 0));
            };
            add(spans_[0]);
            for (int level = 0; level <= cells.levels; ++level) {
                const int n = 1 << level, finer = std::max(level - levels_, 0);
                for (int z = 0; z < n; ++z) {
                    for (int y = 0; y < n; ++y) {
                        for (int x = 0; x < n; ++x) {
                            const Cell cell{level - finer, {x >> finer, y >> finer, z >> finer}};
                            add(spans_[levels_ < 0 ? 0 : cell.place()]);
                        }
                    }
                }
            }
        }
    }

private:
    int levels_within(const Tape& whole, const std::array<Interval, 3>& box,
                      const TapeLimits& limits) const {
        int level = -1;
        if (!functions_.chooses()) return level;
        double sum = 0;
        for (const double work :
             Maker(functions_, are_run_, box, 0, most_levels).work_of_levels(whole)) {
            sum += work;
            if (sum > limits.steps) break;
            ++level;
        }
        return level;
    }

    void go_on(const std::vector<std::pair<Cell, Placed>>& tops, const std::array<Interval, 3>& box,
               const TapeLimits& limits) {
        std::vector<std::vector<std::uint32_t>> words(tops.size());
        base::share({tops.size(), limits.threads}, [&] {
            return [&](std::size_t k) {
                Maker maker(functions_, are_run_, box, words_.size() + k, levels_);
                maker.room = 2 * limits.instructions / tops.size();
                const auto& [top, placed] = tops[k];
                for (int part = 0; part < 8; ++part) {
                    maker.descend(top.part(part), placed, levels_,
                                  [&](const Cell& cell, const Placed& found) {
                                      spans_[cell.place()] = found.spans;
                                  });
                }
                words[k] = std::move(maker.words);
            };
        });
        std::ranges::move(words, std::back_inserter(words_));
    }

    // Cells that were not visited take the spans of those that hold them.
    void inherit(const Cell& cell, const Spans& from) {
        if (cell.level > levels_) return;
        Spans& own = spans_[cell.place()];
        if (own.empty()) own = from;
        for (int k = 0; k < 8; ++k) inherit(cell.part(k), own);
    }

    const TapeFunctions& functions_;
    std::vector<char> are_run_;
    int levels_ = -1;
    std::vector<Spans> spans_;                      // of the whole space, then of the cells
    std::vector<std::vector<std::uint32_t>> words_; // by owner
};

int inputs_of(const Tape& tape) {
    int inputs = 3;
    for (const TapeStep& step : tape.steps) {
        if (step.op == Op::input && step.index >= 3) inputs = 6;
    }
    return inputs;
}

} // namespace

std::optional<TapeFunctions> TapeFunctions::of(const std::vector<TapeRequest>& requests) {
    TapeFunctions made;
    std::vector<TapeSource> sources;
    sources.reserve(requests.size());
    for (const TapeRequest& request : requests)
        sources.push_back({request.program, request.values, request.slopes});
    auto joined = tape_of(sources);
    if (!joined) return {};
    made.joined_ = std::move(*joined);
    int parameters = 0;
    for (const TapeStep& step : made.joined_.steps) {
        if (step.op == Op::parameter) parameters = std::max(parameters, step.index + 1);
    }
    // Any values do: the tape's shape does not depend on them.
    const Tape whole = made.whole(std::vector<float>(std::size_t(parameters), 0.3f));
    int output = 0;
    for (const TapeRequest& request : requests) {
        const int outputs = int(request.program.outputs.size());
        const Tape tape = part_of(whole, output, outputs);
        Function function{TapeOperations(tape, request.numbers), output, outputs};
        function.values = request.values;
        function.slopes = request.slopes;
        function.inputs = inputs_of(tape);
        auto words = words_of(tape, function.operations, function.inputs);
        // An order for all functions may keep much that one of them needs late.
        constexpr int many = 256;
        if (!words || words->registers > many) {
            function.has_own_order = true;
            words = words_of(tape_of(function, whole), function.operations, function.inputs);
        }
        if (!words || !function.operations.have_codes()) return {};
        // Parameters that no literal encloses are loaded.
        constexpr unsigned loaded = 2;
        function.registers = int(std::bit_ceil(unsigned(words->registers) + loaded));
        if (function.registers > most_tape_registers) return {};
        function.turns = words->turns;
        function.noises = words->noises;
        made.functions_.push_back(std::move(function));
        output += outputs;
    }
    made.chooses_ = std::ranges::any_of(whole.steps, decides);
    return made;
}

Tape TapeFunctions::whole(std::span<const float> parameters) const {
    return with_parameters(joined_, std::vector<Interval>(parameters.begin(), parameters.end()));
}

int TapeCells::spans_of_a_function() const { return int(first_of(levels + 1)); }

TapeCells tape_cells(std::span<const TapeFunctions> groups, std::span<const float> parameters,
                     const std::array<Interval, 3>& box, const TapeLimits& limits) {
    TapeCells cells;
    for (std::size_t k = 0; k < 3; ++k) {
        cells.low[k] = box[k].lo;
        cells.size[k] = box[k].hi - box[k].lo;
    }
    std::vector<GroupCells> all;
    std::size_t function = 0;
    for (const TapeFunctions& group : groups) {
        std::vector<char> are_run; // no bits, which threads could not share
        for (std::size_t k = 0; k < group.size(); ++k, ++function)
            are_run.push_back(limits.are_run.empty() || limits.are_run[function]);
        all.emplace_back(group, std::move(are_run), parameters, box, limits);
        cells.levels = std::max(cells.levels, all.back().levels());
    }
    for (const GroupCells& group : all) group.add_to(cells);
    return cells;
}

} // namespace isomotion::formula

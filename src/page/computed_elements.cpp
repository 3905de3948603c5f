#include "page/computed_elements.h"

#include <algorithm>
#include <bit>
#include <map>

#include <nlohmann/json.hpp>

#include "formula/evaluate/evaluate.h"
#include "formula/interval/interval_operations.h"
#include "page/rules.h"

namespace isomotion::page {
namespace {

using formula::Evaluator, formula::Instruction, formula::Interval, formula::Op, formula::Program;

// The part of a field's values that its expression may miss; a field with more is kept whole.
constexpr double most_exceptions = 1.0 / 8;

// Powers are left out: they are no functions of one argument, and browsers have had worse ones.
bool is_known(const Program& program) {
    return std::ranges::none_of(program.instructions,
                                [](const Instruction& now) { return now.op == Op::power; });
}

// The tracks that a program names, and those behind them, each after those it names; false if one
// of them is neither a number nor an expression.
bool add_tracks(const animation::Animation& animation, const Program& program,
                std::vector<int>& order) {
    const auto is_track = [&](int k) { return k < int(animation.nameable()); };
    return is_known(program) && std::ranges::all_of(named_by(program), [&](int track) {
               if (!is_track(track) || std::ranges::count(order, track) > 0) return true;
               const auto& source = animation.tracks()[std::size_t(track)].source;
               const Program* its = animation.program(track);
               if (!its && !std::holds_alternative<double>(source)) return false;
               if (its && !add_tracks(animation, *its, order)) return false;
               order.push_back(track);
               return true;
           });
}

// The fields of an array by rules.h's numbers.
class Fields {
public:
    Fields(const scene::Surface& surface, std::size_t array)
        : animation_(surface.animation)
        , array_(array)
        , order_(fields_in_order(surface, array)) {
        for (std::size_t k = 0; k < order_.size(); ++k) {
            slots_.push_back(slot_of(surface, array, order_[k]));
            can_be_computed_.push_back(can(k));
        }
        // A field that all elements share may not be a field of elements to the shaders.
        const int slots = slots_.empty() ? 0 : 1 + std::ranges::max(slots_);
        stride_ = std::size_t(4 * std::max(1, (slots + 3) / 4));
    }

    std::size_t size() const { return order_.size(); }
    int slot(std::size_t k) const { return slots_[k]; }
    std::size_t column(std::size_t k, std::size_t element) const {
        return element * stride_ + std::size_t(slots_[k]);
    }
    const Program* program(std::size_t k) const { return animation_.program(array_, order_[k]); }
    bool can_be_computed(std::size_t k) const { return can_be_computed_[k]; }
    // The place of a field among the program's parameters.
    std::size_t parameter(std::size_t k) const { return animation_.nameable() + order_[k]; }
    // What is stated; none for a column of samples.
    std::optional<double> stated(std::size_t k, std::size_t element) const {
        const auto& source = animation_.arrays()[array_].fields[order_[k]].source;
        if (const auto* number = std::get_if<double>(&source)) return *number;
        const auto* list = std::get_if<std::vector<double>>(&source);
        if (!list) return std::nullopt;
        return element < list->size() ? (*list)[element] : 0;
    }
    // The fields that others are made of.
    std::vector<bool> needed_by(const std::vector<int>& wanted) const {
        std::vector<bool> needed(size());
        for (const int k : wanted) needed[std::size_t(k)] = true;
        for (std::size_t k = size(); k-- > 0;) {
            if (!needed[k] || !program(k)) continue;
            for (const std::size_t other : siblings(k)) needed[other] = true;
        }
        return needed;
    }

private:
    std::vector<std::size_t> siblings(std::size_t k) const {
        std::vector<std::size_t> all;
        for (const int named : named_by(*program(k))) {
            if (named < int(animation_.nameable())) continue;
            const auto at = std::ranges::find(order_, std::size_t(named) - animation_.nameable());
            all.push_back(std::size_t(at - order_.begin()));
        }
        return all;
    }
    // The siblings that it is made of come before it.
    bool can(std::size_t k) const {
        std::vector<int> tracks;
        if (!program(k) || !add_tracks(animation_, *program(k), tracks)) return false;
        return std::ranges::all_of(siblings(k), [&](std::size_t other) {
            return other < k && (program(other) ? can_be_computed_[other]
                                                : stated(other, 0) || slots_[other] >= 0);
        });
    }

    const animation::Animation& animation_;
    std::size_t array_;
    std::vector<std::size_t> order_;
    std::vector<int> slots_;
    std::vector<bool> can_be_computed_;
    std::size_t stride_;
};

std::vector<int> tracks_of(const scene::Surface& surface, const Fields& fields,
                           const std::vector<bool>& needed) {
    std::vector<int> order;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (needed[k] && fields.program(k))
            add_tracks(surface.animation, *fields.program(k), order);
    }
    return order;
}

bool moves(const Fields& fields, std::size_t k, const ValueTable& values, int elements) {
    for (int i = 0; i < elements; ++i) {
        if (values.moves(fields.column(k, std::size_t(i)))) return true;
    }
    return false;
}

// The only float of an interval.
std::optional<std::uint32_t> float_of(Interval value) {
    const auto low = float(value.lo), high = float(value.hi);
    if (!(low == high)) return std::nullopt; // nor of NaN
    return std::bit_cast<std::uint32_t>(low);
}

// Calls take(field, element, its interval) for those that are wanted, at a time.
class IntervalElements {
public:
    IntervalElements(const scene::Surface& surface, const Fields& fields,
                     const std::vector<int>& wanted)
        : animation_(surface.animation)
        , fields_(fields)
        , needed_(fields.needed_by(wanted))
        , tracks_(tracks_of(surface, fields, needed_)) {
        bindings_.seed = animation_.seed();
        std::size_t most = animation_.nameable();
        for (std::size_t k = 0; k < fields.size(); ++k)
            most = std::max(most, fields.parameter(k) + 1);
        bindings_.parameters.resize(most);
        for (std::size_t k = 0; k < fields.size(); ++k) {
            if (needed_[k] && fields.program(k)) evaluators_.emplace(k, *fields.program(k));
        }
    }

    template<class Take>
    void at(double time, int count, std::size_t row, const ValueTable& values, Take&& take) {
        for (const int track : tracks_) {
            Interval& value = bindings_.parameters[std::size_t(track)];
            const auto& source = animation_.tracks()[std::size_t(track)].source;
            if (const auto* number = std::get_if<double>(&source)) {
                value = *number;
                continue;
            }
            const Interval now(time);
            Evaluator<Interval>(*animation_.program(track))
                .point(bindings_, {&now, 1}, {&value, 1});
        }
        for (int i = 0; i < count; ++i) {
            const Interval inputs[3] = {time, double(i), double(count)};
            for (std::size_t k = 0; k < fields_.size(); ++k) {
                if (!needed_[k]) continue;
                Interval value;
                if (const auto found = evaluators_.find(k); found != evaluators_.end()) {
                    found->second.point(bindings_, inputs, {&value, 1});
                } else if (const auto number = fields_.stated(k, std::size_t(i))) {
                    value = *number;
                } else {
                    const auto word = values.word(row, fields_.column(k, std::size_t(i)));
                    value = double(std::bit_cast<float>(word));
                }
                bindings_.parameters[fields_.parameter(k)] = value;
                take(k, i, value);
            }
        }
    }

private:
    const animation::Animation& animation_;
    const Fields& fields_;
    std::vector<bool> needed_;
    std::vector<int> tracks_;
    formula::Bindings<Interval> bindings_;
    std::map<std::size_t, Evaluator<Interval>> evaluators_;
};

} // namespace

std::optional<ComputedElements> computed_elements(const scene::Surface& surface, std::size_t array,
                                                  const ValueTable& values,
                                                  std::span<const double> times,
                                                  std::span<const int> counts) {
    const int elements = surface.animation.arrays()[array].count;
    if (elements == 0 || elements > most_computed) return std::nullopt;
    const Fields fields(surface, array);
    ComputedElements computed;
    for (std::size_t k = 0; k < fields.size(); ++k) {
        if (fields.slot(k) >= 0 && fields.can_be_computed(k) && moves(fields, k, values, elements))
            computed.fields.push_back(int(k));
    }
    if (computed.fields.empty()) return std::nullopt;

    std::vector<std::vector<ComputedElements::Exception>> exceptions(fields.size());
    IntervalElements evaluated(surface, fields, computed.fields);
    for (std::size_t row = 0; row < times.size(); ++row) {
        evaluated.at(times[row], counts[row], row, values, [&](std::size_t k, int i, Interval it) {
            if (fields.slot(k) < 0) return;
            const std::size_t column = fields.column(k, std::size_t(i));
            const std::uint32_t word = values.word(row, column);
            if (float_of(it) != word)
                exceptions[k].push_back({std::uint32_t(row), std::uint32_t(column), word});
        });
    }
    const double of_a_field = double(elements) * double(times.size());
    std::erase_if(computed.fields, [&](int k) {
        return double(exceptions[std::size_t(k)].size()) > most_exceptions * of_a_field;
    });
    if (computed.fields.empty()) return std::nullopt;
    for (const int k : computed.fields) {
        const auto& its = exceptions[std::size_t(k)];
        computed.exceptions.insert(computed.exceptions.end(), its.begin(), its.end());
    }
    std::ranges::sort(computed.exceptions, [](const auto& a, const auto& b) {
        return std::pair(a.row, a.column) < std::pair(b.row, b.column);
    });
    return computed;
}

ValueTable without(const ComputedElements& computed, const scene::Surface& surface,
                   std::size_t array, const ValueTable& values) {
    const Fields fields(surface, array);
    const int elements = surface.animation.arrays()[array].count;
    ValueTable rest = values;
    for (const int k : computed.fields) {
        for (int i = 0; i < elements; ++i)
            rest.clear(fields.column(std::size_t(k), std::size_t(i)));
    }
    return rest;
}

void pack(const ComputedElements& computed, std::vector<std::byte>& into) {
    const auto append = [&](std::uint32_t word) {
        for (int place = 0; place < 4; ++place)
            into.push_back(std::byte(word >> (8 * place) & 0xff));
    };
    append(std::uint32_t(computed.exceptions.size()));
    for (const auto& [row, column, word] : computed.exceptions) {
        append(row);
        append(column);
        append(word);
    }
}

nlohmann::ordered_json json_of(const ComputedElements& computed, const scene::Surface& surface,
                               std::size_t array) {
    using Json = nlohmann::ordered_json;
    const animation::Animation& animation = surface.animation;
    const Fields fields(surface, array);
    Json tracks = Json::array();
    for (const int track : tracks_of(surface, fields, fields.needed_by(computed.fields))) {
        const Program* program = animation.program(track);
        const auto& source = animation.tracks()[std::size_t(track)].source;
        tracks.push_back(
            {track, program ? program_of_track(animation, track) : Json(std::get<double>(source))});
    }
    return {{"fields", computed.fields}, {"tracks", tracks}};
}

} // namespace isomotion::page

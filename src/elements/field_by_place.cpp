#include "elements/field_by_place.h"

#include <algorithm>
#include <array>

#include "formula/interval/interval_operations.h"

namespace isomotion::elements {
namespace {

// Larger boxes are not looked at.
constexpr std::size_t most_cells = 1024, most_found = 8192;

// The array that comes first where several have as many.
std::vector<int> by_size(std::span<const int> elements_of_arrays) {
    std::vector<int> arrays;
    for (std::size_t a = 0; a < elements_of_arrays.size(); ++a) arrays.push_back(int(a));
    std::ranges::stable_sort(arrays, std::greater<>(),
                             [&](int a) { return elements_of_arrays[std::size_t(a)]; });
    return arrays;
}

} // namespace

std::optional<FieldByPlace> FieldByPlace::of(const formula::Field& field,
                                             std::span<const int> elements_of_arrays) {
    for (const int array : by_size(elements_of_arrays)) {
        if (elements_of_arrays[std::size_t(array)] <= few) break;
        std::optional<GridMaker> grid_maker = GridMaker::of(field, array);
        if (!grid_maker) continue;
        if (auto programs = formula::enclosures_apart(field, array))
            return FieldByPlace(std::move(*grid_maker), std::move(*programs));
    }
    return std::nullopt;
}

FieldByPlace::Frame FieldByPlace::at(const formula::Bindings<float>& bindings, const Region& region,
                                     int threads, std::shared_ptr<const ElementGrid> made) const {
    const auto array = std::size_t(grid_maker_.array());
    Frame frame;
    frame.of_ = this;
    if (!made || made->array != grid_maker_.array()) {
        made = std::make_shared<const ElementGrid>(
            grid_maker_.make(bindings, region, {.threads = threads}));
    }
    frame.grid_ = std::move(made);
    frame.region_ = region;
    frame.elements_ = bindings.arrays[array].count;
    frame.columns_ = bindings.arrays[array].fields;
    formula::Bindings<float> others = bindings;
    others.arrays[array] = {};
    frame.others_ = formula::convert<Interval>(others);
    return frame;
}

FieldByPlace::Frame::Rest FieldByPlace::Frame::rest(const formula::SumsApart::Sum& sum) const {
    if (sum.op != formula::Op::sum) {
        const Interval least(double(grid_->least), formula::infinity);
        return {sum.op == formula::Op::least ? least : Interval::entire(), least};
    }
    const std::vector<formula::NodeId>& own = programs().sums_of_field;
    const auto at = std::ranges::find(own, sum.node);
    if (at == own.end() || grid_->left_out.empty()) return {0.0, 0.0};
    const double most = 2 * grid_->left_out[std::size_t(at - own.begin())];
    return {{-most, most}, 0.0};
}

BoxesByPlace::BoxesByPlace(const formula::SumsApart& program, const FieldByPlace::Frame& frame)
    : program_(program)
    , frame_(frame)
    , terms_(program.terms)
    , rest_(program.rest)
    , seen_(std::size_t(frame.elements()), 0)
    , places_(std::size_t(program.places))
    , fields_(program.fields.size())
    , term_values_(program.terms.outputs.size())
    , sums_(program.sums.size()) {
    for (const formula::SumsApart::Sum& sum : program.sums) left_out_.push_back(frame.rest(sum));
}

bool BoxesByPlace::look_up(const Interval& x, const Interval& y, const Interval& z) {
    const ElementGrid& grid = frame_.grid();
    const glm::dvec3 low(x.lo, y.lo, z.lo), high(x.hi, y.hi, z.hi);
    const Region& region = frame_.region();
    if (!glm::all(glm::greaterThanEqual(low, region.low)) ||
        !glm::all(glm::lessThanEqual(high, region.high))) {
        return false;
    }
    const glm::ivec3 first = grid.place(low), last = grid.place(high);
    const glm::ivec3 cells = last - first + 1;
    if (std::size_t(cells.x) * std::size_t(cells.y) * std::size_t(cells.z) > most_cells)
        return false;
    found_.clear();
    if (++turn_ == 0) { // numbers begin anew
        std::ranges::fill(seen_, 0);
        turn_ = 1;
    }
    const bool is_alone = cells == glm::ivec3(1);
    for (int k = first.z; k <= last.z; ++k) {
        for (int j = first.y; j <= last.y; ++j) {
            for (int i = first.x; i <= last.x; ++i) {
                for (const std::uint32_t element : grid.list(grid.at({i, j, k}))) {
                    if (!is_alone && std::exchange(seen_[element], turn_) == turn_) continue;
                    found_.push_back(element);
                }
            }
        }
        if (!is_alone && found_.size() > most_found) return false;
    }
    return true;
}

void BoxesByPlace::add_up(std::span<const std::span<const Interval>> inputs, std::size_t box) {
    const std::size_t count = found_.size();
    std::vector<std::span<const Interval>> from;
    for (std::size_t k = 0; k < places_.size(); ++k) {
        places_[k].assign(count, inputs[k][box]);
        from.emplace_back(places_[k]);
    }
    for (std::size_t f = 0; f < fields_.size(); ++f) {
        const std::span<const float> column = frame_.column(program_.fields[f]);
        fields_[f].clear();
        for (const std::uint32_t element : found_) fields_[f].emplace_back(double(column[element]));
        from.emplace_back(fields_[f]);
    }
    std::vector<std::span<Interval>> to;
    for (auto& values : term_values_) {
        values.resize(count);
        to.emplace_back(values);
    }
    terms_.points(frame_.others(), from, to);
    for (std::size_t k = 0; k < sums_.size(); ++k) sums_[k][box] = over_found(k);
}

Interval BoxesByPlace::over_found(std::size_t which) const {
    using Do = formula::Operations<Interval>;
    const formula::SumsApart::Sum& sum = program_.sums[which];
    const std::vector<Interval>& terms = term_values_[std::size_t(sum.term)];
    auto [all, least] = left_out_[which];
    for (std::size_t k = 0; k < terms.size(); ++k) {
        switch (sum.op) {
        case formula::Op::sum:
            all = all + terms[k];
            break;
        case formula::Op::least:
            all = Do::min(terms[k], all);
            break;
        default: {
            const bool picks = sum.op == formula::Op::pick;
            const Interval value =
                picks ? term_values_[std::size_t(sum.term + 1)][k] : Interval(double(k + 1));
            all = Do::select(terms[k], least, value, all);
            least = Do::min(terms[k], least);
        }
        }
    }
    return all;
}

void BoxesByPlace::points(std::span<const std::span<const Interval>> inputs,
                          std::span<const std::span<Interval>> outputs) {
    const std::size_t boxes = inputs.empty() ? 0 : inputs[0].size();
    std::vector<bool> is_known(boxes);
    for (auto& sum : sums_) sum.assign(boxes, Interval(0.0));
    for (std::size_t box = 0; box < boxes; ++box) {
        is_known[box] = look_up(inputs[0][box], inputs[1][box], inputs[2][box]);
        if (is_known[box] && !sums_.empty()) add_up(inputs, box);
    }
    std::vector<std::span<const Interval>> from(inputs.begin(), inputs.begin() + program_.places);
    for (const auto& sum : sums_) from.emplace_back(sum);
    rest_.points(frame_.others(), from, outputs);
    for (std::size_t box = 0; box < boxes; ++box) {
        if (is_known[box]) continue;
        for (const std::span<Interval>& output : outputs) output[box] = Interval::entire();
    }
}

} // namespace isomotion::elements

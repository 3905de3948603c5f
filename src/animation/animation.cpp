#include "animation/animation.h"

#include <algorithm>
#include <functional>
#include <unordered_set>

#include <fmt/format.h>

#include "formula/graph/lowering.h"
#include "formula/graph/parser.h"

namespace isomotion::animation {
namespace {

enum Input { input_time, input_index, input_count };

// An order in which every item comes after what it refers to. Refuses items that refer to
// themselves in the end, and chains that go on for too long; follows them without recursion.
std::vector<int> dependency_order(std::size_t count,
                                  const std::function<std::vector<int>(int)>& references,
                                  const std::function<std::string(int)>& name) {
    enum class State : char { untouched, open, done };
    struct Open {
        int item;
        std::vector<int> rest; // references not yet followed, the next one last
    };
    std::vector<State> state(count, State::untouched);
    std::vector<std::size_t> length(count, 1); // of the longest chain that begins with the item
    std::vector<int> order;
    std::vector<Open> path;
    const auto begin = [&](int item) {
        std::vector<int> rest = references(item);
        std::ranges::reverse(rest);
        state[std::size_t(item)] = State::open;
        path.push_back({item, std::move(rest)});
    };
    for (std::size_t k = 0; k < count; ++k) {
        if (state[k] == State::untouched) begin(int(k));
        while (!path.empty()) {
            const int item = path.back().item;
            if (path.back().rest.empty()) {
                state[std::size_t(item)] = State::done;
                order.push_back(item);
                path.pop_back();
                continue;
            }
            const int next = path.back().rest.back();
            if (state[std::size_t(next)] == State::untouched) {
                begin(next); // and then looks at it again
                continue;
            }
            if (state[std::size_t(next)] == State::open) {
                throw ExpressionError(
                    name(next), fmt::format("the value of '{}' depends on itself", name(next)));
            }
            path.back().rest.pop_back();
            std::size_t& longest = length[std::size_t(item)];
            longest = std::max(longest, length[std::size_t(next)] + 1);
            if (longest > formula::limits::chain) {
                throw ExpressionError(
                    name(item),
                    fmt::format("the value of '{}' depends on others through a chain of "
                                "more than {}; let it name directly what it needs",
                                name(item), formula::limits::chain));
            }
        }
    }
    return order;
}

// Whole words only: "cx" is no mention of "x".
std::unordered_set<std::string_view> words_of(std::string_view text) {
    const auto part = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
    };
    std::unordered_set<std::string_view> words;
    for (auto begin = text.begin(); begin != text.end();) {
        const auto end = std::find_if_not(begin, text.end(), part);
        if (end != begin) words.emplace(begin, end);
        begin = std::find_if(end, text.end(), part);
    }
    return words;
}

} // namespace

bool Values::operator==(const Values& other) const {
    // Time itself doesn't count: equal values give equal pictures.
    if (tracks != other.tracks || arrays.size() != other.arrays.size()) return false;
    return std::equal(
        arrays.begin(), arrays.end(), other.arrays.begin(),
        [](const auto& a, const auto& b) { return a.count == b.count && a.fields == b.fields; });
}

Animation::Animation(std::vector<Track> tracks, std::vector<Array> arrays, std::uint64_t seed)
    : tracks_(std::move(tracks))
    , arrays_(std::move(arrays))
    , seed_(seed)
    , referenced_(tracks_.size(), false) {
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        if (formula::is_identifier(tracks_[k].name)) nameable_ = k + 1;
    }
    // Arrays first: a field that stands alone is also a track, but its mistakes are better told
    // with the names that fields know.
    for (const Array& array : arrays_) compile_array(array);
    compile_tracks();
}

Animation::Compiled Animation::compile(const std::string& owner, const std::string& text,
                                       const formula::Names& names) const {
    formula::Graph graph;
    formula::NodeId root{};
    try {
        root = formula::parse(text, names, graph);
    } catch (const formula::ParseError& error) {
        throw ExpressionError(owner, error.what());
    }
    Compiled compiled;
    compiled.program = formula::schedule_lowered(graph, root);
    for (const auto& instruction : compiled.program.instructions) {
        if (instruction.kind == formula::Instruction::Kind::operation &&
            instruction.op == formula::Op::parameter) {
            compiled.references.push_back(instruction.index);
        }
    }
    return compiled;
}

std::vector<std::string> Animation::track_names() const {
    std::vector<std::string> names;
    for (std::size_t k = 0; k < nameable_; ++k) names.push_back(tracks_[k].name);
    return names;
}

void Animation::compile_tracks() {
    formula::Vocabulary vocabulary;
    vocabulary.inputs = {"t"};
    vocabulary.parameters = track_names();
    vocabulary.allows_random = true;
    const formula::Names names(vocabulary);
    compiled_.resize(tracks_.size());
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        const auto* expression = std::get_if<Expression>(&tracks_[k].source);
        if (!expression) continue;
        const Compiled& compiled =
            compiled_[k].emplace(compile(tracks_[k].name, expression->text, names));
        for (const int other : compiled.references) referenced_[std::size_t(other)] = true;
    }
    order_ = dependency_order(
        tracks_.size(),
        [this](int k) {
            const auto& compiled = compiled_[std::size_t(k)];
            return compiled ? compiled->references : std::vector<int>{};
        },
        [this](int k) { return tracks_[std::size_t(k)].name; });
}

void Animation::compile_array(const Array& array) {
    formula::Vocabulary vocabulary;
    vocabulary.inputs = {"t", "i", "n"};
    vocabulary.parameters = track_names();
    const auto tracks = int(vocabulary.parameters.size());
    for (const ArrayField& field : array.fields) vocabulary.parameters.push_back(field.name);
    vocabulary.allows_random = true;
    const formula::Names names(vocabulary);

    CompiledArray compiled;
    compiled.fields.resize(array.fields.size());
    compiled.referenced.resize(array.fields.size(), false);
    for (std::size_t f = 0; f < array.fields.size(); ++f) {
        const auto* expression = std::get_if<Expression>(&array.fields[f].source);
        if (!expression) continue;
        const std::string owner = array.name + "." + array.fields[f].name;
        const Compiled& field = compiled.fields[f].emplace(compile(owner, expression->text, names));
        for (const int other : field.references) {
            if (other < tracks) {
                referenced_[std::size_t(other)] = true;
            } else {
                compiled.referenced[std::size_t(other - tracks)] = true;
            }
        }
    }
    compiled.order = dependency_order(
        array.fields.size(),
        [&](int f) {
            std::vector<int> siblings;
            if (const auto& field = compiled.fields[std::size_t(f)]) {
                for (const int other : field->references) {
                    if (other >= tracks) siblings.push_back(other - tracks);
                }
            }
            return siblings;
        },
        [&](int f) { return array.name + "." + array.fields[std::size_t(f)].name; });
    leave_out_unread(array, compiled);
    compiled_arrays_.push_back(std::move(compiled));
}

// Siblings that others are made of come before them in the order.
void Animation::leave_out_unread(const Array& array, CompiledArray& compiled) const {
    const auto tracks = int(nameable_);
    std::vector<bool> is_needed;
    for (const ArrayField& field : array.fields) is_needed.push_back(field.is_read);
    for (auto f = compiled.order.rbegin(); f != compiled.order.rend(); ++f) {
        const auto& expression = compiled.fields[std::size_t(*f)];
        if (!is_needed[std::size_t(*f)] || !expression) continue;
        for (const int other : expression->references) {
            if (other >= tracks) is_needed[std::size_t(other - tracks)] = true;
        }
    }
    std::erase_if(compiled.order, [&](int f) { return !is_needed[std::size_t(f)]; });
}

// Files may have many columns, and be long.
void Animation::leave_out_columns(Array& array, const CompiledArray& compiled) {
    if (!array.samples) return;
    std::vector<bool> columns(array.samples->source().columns());
    for (const int f : compiled.order) {
        const auto* column = std::get_if<Column>(&array.fields[std::size_t(f)].source);
        if (column) columns[column->index] = true;
    }
    array.samples = std::make_shared<const ElementSamples>(array.samples->only(columns));
}

void Animation::keep_fields(const std::vector<std::vector<int>>& read) {
    for (std::size_t a = 0; a < arrays_.size(); ++a) {
        for (ArrayField& field : arrays_[a].fields) field.is_read = false;
        for (const int field : read[a]) arrays_[a].fields[std::size_t(field)].is_read = true;
        leave_out_unread(arrays_[a], compiled_arrays_[a]);
        leave_out_columns(arrays_[a], compiled_arrays_[a]);
    }
}

Values Animation::at(double time) const {
    Values values;
    values.time = time;
    values.tracks.resize(tracks_.size());
    formula::Bindings<double> bindings;
    bindings.seed = seed_;
    bindings.parameters.resize(tracks_.size());
    for (const int k : order_) {
        const auto index = std::size_t(k);
        double& value = bindings.parameters[index];
        const TrackSource& source = tracks_[index].source;
        if (const auto* number = std::get_if<double>(&source)) {
            value = *number;
        } else if (const auto* keys = std::get_if<Keys>(&source)) {
            value = keys->at(time);
        } else if (const auto& compiled = compiled_[index]) {
            double result = 0;
            formula::Evaluator<double>(compiled->program).point(bindings, {&time, 1}, {&result, 1});
            value = result;
        }
    }
    values.tracks = bindings.parameters;
    for (std::size_t a = 0; a < arrays_.size(); ++a) values.arrays.push_back(columns(a, values));
    return values;
}

formula::ArrayColumns<double> Animation::columns(std::size_t a, const Values& values) const {
    const Array& array = arrays_[a];
    const CompiledArray& compiled = compiled_arrays_[a];
    formula::ArrayColumns<double> columns;
    formula::ArrayColumns<double> sampled;
    if (array.samples) sampled = array.samples->at(values.time);
    columns.count = array.samples ? sampled.count : array.count;
    columns.fields.resize(array.fields.size());
    const auto count = std::size_t(columns.count);
    const std::size_t tracks = nameable_;

    formula::Bindings<double> bindings;
    bindings.seed = seed_;
    bindings.parameters.assign(values.tracks.begin(),
                               values.tracks.begin() + std::ptrdiff_t(tracks));
    bindings.parameters.resize(tracks + array.fields.size());
    for (const int f : compiled.order) {
        const auto field = std::size_t(f);
        auto& column = columns.fields[field];
        if (const auto* number = std::get_if<double>(&array.fields[field].source)) {
            column.assign(count, *number);
        } else if (const auto* list =
                       std::get_if<std::vector<double>>(&array.fields[field].source)) {
            column = *list;
            column.resize(count);
        } else if (const auto* data = std::get_if<Column>(&array.fields[field].source)) {
            column = sampled.fields[data->index]; // two fields may be one column
        } else if (const auto& expression = compiled.fields[field]) {
            formula::Evaluator<double> evaluator(expression->program);
            column.resize(count);
            for (std::size_t i = 0; i < count; ++i) {
                for (const int other : expression->references) {
                    if (std::size_t(other) < tracks) continue;
                    bindings.parameters[std::size_t(other)] =
                        columns.fields[std::size_t(other) - tracks][i];
                }
                const double inputs[3] = {values.time, double(i), double(count)};
                evaluator.point(bindings, inputs, {&column[i], 1});
            }
        }
    }
    return columns;
}

std::vector<int> Animation::counts() const {
    std::vector<int> counts;
    for (const Array& array : arrays_) counts.push_back(array.count);
    return counts;
}

const formula::Program* Animation::program(int track) const {
    const auto& compiled = compiled_[std::size_t(track)];
    return compiled ? &compiled->program : nullptr;
}

const formula::Program* Animation::program(std::size_t array, std::size_t field) const {
    const auto& compiled = compiled_arrays_[array].fields[field];
    return compiled ? &compiled->program : nullptr;
}

double Animation::operations() const {
    double total = double(tracks_.size());
    for (const std::optional<Compiled>& track : compiled_) {
        if (track) total += formula::cost(track->program, {}).operations;
    }
    return total;
}

double Animation::operations(std::size_t array) const {
    const CompiledArray& compiled = compiled_arrays_[array];
    double total = 0;
    for (const int f : compiled.order) {
        const auto& field = compiled.fields[std::size_t(f)];
        total += 1 + (field ? formula::cost(field->program, {}).operations : 0);
    }
    return total * arrays_[array].count;
}

double Animation::values(std::size_t array) const {
    return double(compiled_arrays_[array].order.size()) * arrays_[array].count;
}

std::optional<int> Animation::find(std::string_view track) const {
    for (std::size_t k = 0; k < tracks_.size(); ++k) {
        if (tracks_[k].name == track) return int(k);
    }
    return std::nullopt;
}

bool stands_alone(const Array& array, std::size_t field) {
    const FieldSource& source = array.fields[field].source;
    if (std::holds_alternative<double>(source)) return true;
    const auto* expression = std::get_if<Expression>(&source);
    // What is too long is refused when it is read.
    if (!expression || expression->text.size() > formula::limits::formula_bytes) return false;
    const auto words = words_of(expression->text);
    if (words.contains("i") || words.contains("n")) return false;
    return std::ranges::none_of(
        array.fields, [&](const ArrayField& sibling) { return words.contains(sibling.name); });
}

} // namespace isomotion::animation

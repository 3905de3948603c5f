#include "animation/element_samples.h"

#include <algorithm>
#include <tuple>

namespace isomotion::animation {
namespace {

// The cubic with these values and these velocities at both ends, as u goes from 0 to 1.
double hermite(double from, double to, double from_velocity, double to_velocity, double u) {
    const double way = to - from;
    const double square = 3 * way - 2 * from_velocity - to_velocity;
    const double cube = from_velocity + to_velocity - 2 * way;
    return from + u * (from_velocity + u * (square + u * cube));
}

} // namespace

struct ElementSamples::Pair {
    std::size_t begin = 0;
    bool moves = false; // towards the next one
    double weight = 0;  // of the next one, 0 to 1
    double seconds = 0; // from one to the other
};

ElementSamples::ElementSamples(Rows rows, Interpolation interpolation)
    : ElementSamples(std::make_shared<const SampleTable>(std::move(rows)), interpolation) {}

ElementSamples::ElementSamples(std::shared_ptr<const SampleSource> source,
                               Interpolation interpolation)
    : source_(std::move(source))
    , interpolation_(interpolation)
    , reads_(source_->columns(), true)
    , factors_(source_->columns(), 1.0) {
    forget();
}

void ElementSamples::forget() {
    memo_ = std::make_shared<Memo>();
    memo_->changes.resize(times().size());
}

ElementSamples ElementSamples::multiplied(std::size_t column, double factor) const {
    ElementSamples samples = *this;
    samples.factors_[column] *= factor;
    samples.forget();
    return samples;
}

ElementSamples ElementSamples::only(std::vector<bool> columns) const {
    ElementSamples samples = *this;
    samples.reads_ = std::move(columns);
    samples.forget();
    return samples;
}

std::optional<std::size_t> ElementSamples::velocity_of(std::size_t column) const {
    if (interpolation_ != Interpolation::hermite) return std::nullopt;
    return source_->velocity_of(column);
}

bool ElementSamples::is_curved(std::size_t column) const { return velocity_of(column).has_value(); }

std::span<const double> ElementSamples::velocities(const SampleSource::Sample& sample,
                                                   std::size_t column) const {
    const auto velocity = velocity_of(column);
    if (!velocity) return {};
    return sample.columns[*velocity];
}

// The columns that are read, and the velocities of those that need them.
std::vector<bool> ElementSamples::needed() const {
    std::vector<bool> columns = reads_;
    for (std::size_t c = 0; c < reads_.size(); ++c) {
        const auto velocity = velocity_of(c);
        if (reads_[c] && velocity) columns[*velocity] = true;
    }
    return columns;
}

ElementSamples::Pair ElementSamples::pair(double time) const {
    const std::vector<double>& all = times();
    const auto next = std::size_t(std::ranges::upper_bound(all, time) - all.begin());
    Pair pair{next > 0 ? next - 1 : 0};
    if (interpolation_ == Interpolation::hold || next == 0 || next == all.size()) return pair;
    pair.moves = true;
    pair.seconds = all[next] - all[pair.begin];
    pair.weight = (time - all[pair.begin]) / pair.seconds;
    return pair;
}

std::vector<double> ElementSamples::exact(const SampleSource::Sample& sample,
                                          std::size_t column) const {
    const std::span<const double> values = sample.columns[column];
    std::vector<double> result(values.begin(), values.end());
    if (factors_[column] != 1) {
        for (double& value : result) value *= factors_[column];
    }
    return result;
}

formula::ArrayColumns<double> ElementSamples::at(double time) const {
    const Pair around = pair(time);
    if (around.weight > 0) {
        Span moving = span(time);
        const double u = around.weight;
        for (std::size_t c = 0; c < reads_.size(); ++c) {
            std::vector<double>& column = moving.begin.fields[c];
            const std::vector<double>& end = moving.end[c];
            for (std::size_t i = 0; i < column.size(); ++i) {
                column[i] = is_curved(c) ? hermite(column[i], end[i], moving.begin_velocity[c][i],
                                                   moving.end_velocity[c][i], u)
                                         : column[i] + u * (end[i] - column[i]);
            }
        }
        return std::move(moving.begin);
    }
    const SampleSource::Sample sample = source_->sample(around.begin, reads_);
    formula::ArrayColumns<double> columns;
    columns.count = int(sample.count);
    for (std::size_t c = 0; c < reads_.size(); ++c)
        columns.fields.push_back(reads_[c] ? exact(sample, c) : std::vector<double>{});
    return columns;
}

std::pair<double, double> ElementSamples::ends(double time) const {
    const std::size_t begin = pair(time).begin;
    const double first = times()[begin];
    const bool stays = time < first || begin + 1 == times().size();
    return {first, stays ? first : times()[begin + 1]};
}

std::size_t ElementSamples::sample_at(double time) const { return pair(time).begin; }

int ElementSamples::count(double time) const {
    return int(source_->sample(pair(time).begin, std::vector<bool>(reads_.size())).count);
}

ElementSamples::Span ElementSamples::span(double time) const {
    const Pair around = pair(time);
    const std::vector<bool> columns = needed();
    const SampleSource::Sample here = source_->sample(around.begin, columns);
    Span span;
    span.begin.count = int(here.count);
    std::tie(span.begin_time, span.end_time) = ends(time);
    for (Columns* all : {&span.begin.fields, &span.end, &span.begin_velocity, &span.end_velocity})
        all->resize(reads_.size());
    SampleSource::Sample there;
    SampleSource::Successors same(0);
    if (around.moves) {
        there = source_->sample(around.begin + 1, columns);
        same = source_->successors(around.begin);
    }
    for (std::size_t c = 0; c < reads_.size(); ++c) {
        if (!reads_[c]) continue;
        span.begin.fields[c] = exact(here, c);
        span.end[c] = span.begin.fields[c];
        std::span<const double> leaving, arriving; // velocities
        if (is_curved(c)) {
            span.begin_velocity[c].resize(here.count);
            span.end_velocity[c].resize(here.count);
            leaving = velocities(here, c);
            if (around.moves) arriving = velocities(there, c);
        }
        if (!around.moves) continue;
        const double factor = factors_[c], unit = factor * around.seconds;
        for (std::size_t i = 0; i < here.count; ++i) {
            const std::uint32_t next = same.of(i);
            const bool stays = next == SampleSource::Successors::none;
            if (!stays) span.end[c][i] = factor * there.columns[c][next];
            if (leaving.empty()) continue;
            const double velocity = unit * leaving[i];
            if (stays) span.end[c][i] += velocity;
            span.begin_velocity[c][i] = velocity;
            span.end_velocity[c][i] = stays ? velocity : unit * arriving[next];
        }
    }
    return span;
}

ElementSamples::Change ElementSamples::find_change(std::size_t k) const {
    const bool holds = interpolation_ == Interpolation::hold;
    const std::vector<bool> columns = holds ? reads_ : std::vector<bool>(reads_.size());
    const SampleSource::Sample before = source_->sample(k - 1, columns);
    const SampleSource::Sample after = source_->sample(k, columns);
    const SampleSource::Successors same = source_->successors(k - 1);
    Change change;
    change.recounts = change.jumps = before.count != after.count;
    for (std::size_t row = 0; row < before.count; ++row) {
        const std::uint32_t next = same.of(row);
        if (next == SampleSource::Successors::none) {
            change.jumps = true;
            continue;
        }
        change.reorders = change.reorders || next != row;
        for (std::size_t c = 0; holds && !change.jumps && c < reads_.size(); ++c)
            change.jumps = reads_[c] && before.columns[c][row] != after.columns[c][next];
    }
    return change;
}

ElementSamples::Change ElementSamples::change(std::size_t k) const {
    if (k == 0) return {}; // before the first sample it is there already
    {
        const std::lock_guard lock(memo_->mutex);
        const auto& known = memo_->changes[k];
        if (known) return *known;
    }
    const Change found = find_change(k);
    const std::lock_guard lock(memo_->mutex);
    memo_->changes[k] = found;
    return found;
}

bool ElementSamples::jumps(std::size_t k) const { return change(k).jumps; }
bool ElementSamples::recounts(std::size_t k) const { return change(k).recounts; }
bool ElementSamples::reorders(std::size_t k) const { return change(k).reorders; }

void ElementSamples::add_column(base::Fingerprint& print, std::size_t column) const {
    source_->add_column(print, column);
    if (factors_[column] != 1) print.add_values(std::span<const double>(&factors_[column], 1));
}

void ElementSamples::add_rows(base::Fingerprint& print) const {
    const auto rule = double(interpolation_);
    print.add_values(std::span<const double>(&rule, 1));
    source_->add_rows(print);
    for (std::size_t c = 0; c < reads_.size(); ++c) {
        const auto velocity = velocity_of(c);
        if (!reads_[c] || !velocity) continue;
        print.add("velocity");
        source_->add_column(print, *velocity);
    }
}

} // namespace isomotion::animation

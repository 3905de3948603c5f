#include "methods/contest.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>

#include "accuracy/truth_cache.h"
#include "formula/graph/program.h"
#include "roots/tube.h"
#include "shader/assemble.h"

namespace isomotion::bench {
namespace {

using accuracy::Setting;
using shader::Channel;

constexpr double minute = 60e3; // ms

Setting setting(const scene::Scene& scene, scene::Method method, int halvings = 0) {
    return {method, std::ldexp(scene.surfaces[0].isolation.step, -halvings), 1,
            scene.surfaces[0].isolation.bisections, scene.surfaces[0].isolation.safety};
}

double ms(const render::Picture& picture) {
    return std::chrono::duration<double, std::milli>(picture.drawing).count();
}

// The sign test at steps finer and finer, counted when asked for.
class Ladder {
public:
    Ladder(gpu::Context& context, const Certified& on, int most_halvings)
        : context_(context)
        , on_(on)
        , most_halvings_(most_halvings) {}

    const Count& at(int halvings) {
        while (int(counts_.size()) <= halvings) {
            counts_.push_back(
                count(context_, on_,
                      setting(on_.subject.scene, scene::Method::amp_sign, int(counts_.size()))));
        }
        return counts_[std::size_t(halvings)];
    }

    struct Rung {
        int halvings = 0;
        bool reached = false;
    };
    // The first with no more wrong pixels, or the last.
    Rung as_right_as(std::int64_t wrong) {
        for (int halvings = 0; halvings <= most_halvings_; ++halvings) {
            if (at(halvings).errors.wrong() <= wrong) return {halvings, true};
        }
        return {most_halvings_, false};
    }

private:
    gpu::Context& context_;
    const Certified& on_;
    int most_halvings_;
    std::vector<Count> counts_;
};

} // namespace

Certified uncertified(Subject subject, int size) {
    Certified on{std::move(subject), {}, {}};
    on.subject.scene.output.width = on.subject.scene.output.height = size;
    for (const int frame : on.subject.frames) {
        // Hits are compared by their positions, which float can't tell apart far from the origin.
        on.frames.push_back(
            scene::in_formula_coordinates(scene::at_frame(on.subject.scene, frame)));
    }
    return on;
}

Certified certified(Subject subject, int size, const std::filesystem::path& cache,
                    const Progress& progress) {
    Certified on = uncertified(std::move(subject), size);
    for (const scene::SceneAt& now : on.frames) {
        roots::Certifying certifying;
        certifying.progress = [&](double part) {
            if (progress) progress((double(on.truths.size()) + part) / double(on.frames.size()));
        };
        on.truths.push_back(
            accuracy::remembered_truth(on.subject.scene, now, size, size, certifying, cache));
    }
    return on;
}

Count count(gpu::Context& context, const Certified& on, const Setting& how) {
    const scene::Scene scene = accuracy::apply(how, on.subject.scene);
    render::Renderer renderer(
        context, scene,
        {on.width(), on.height(), {Channel::normal, Channel::position, Channel::verdict}, {}});
    Count found;
    for (std::size_t k = 0; k < on.frames.size(); ++k) {
        const render::Picture picture = renderer.draw(on.frames[k]);
        found.evaluations += double(picture.evaluations());
        found.errors.add(accuracy::compare(on.frames[k], picture.frame, on.truths[k]));
    }
    found.errors.depth.clear();
    found.errors.normal.clear();
    return found;
}

std::int64_t rays(const Certified& on) {
    std::int64_t meeting = 0;
    for (const scene::SceneAt& now : on.frames) {
        const roots::Tubes tubes(now, on.width(), on.height());
        for (int row = 0; row < on.height(); ++row) {
            for (int column = 0; column < on.width(); ++column) {
                const roots::Tube tube = tubes.at(column, row);
                meeting += tube.near <= tube.far;
            }
        }
    }
    return meeting;
}

double operations(const scene::Scene& scene, scene::Method method) {
    scene::Scene with = scene;
    with.surfaces[0].isolation.method = method;
    const shader::Passes passes = shader::assemble(with);
    std::vector<int> counts;
    for (const auto& array : passes.arrays) counts.push_back(array.capacity);
    // Other methods ask for bounds of F only where samples leave doubt.
    std::vector<shader::FieldFunction> of_a_sample = passes.samples;
    if (scene::traits(method).steps != scene::Steps::bounds) {
        std::erase_if(of_a_sample, [](shader::FieldFunction function) {
            return function != shader::FieldFunction::rough && is_on_intervals(function);
        });
    }
    return shader::cost(*scene.surfaces[0].field, passes, of_a_sample, counts).operations;
}

double ratio(const Timing& slow, const Timing& fast) {
    std::vector<double> ratios;
    for (std::size_t k = 0; k < slow.rounds.size(); ++k) {
        ratios.push_back(slow.rounds[k] / fast.rounds[k]);
    }
    std::sort(ratios.begin(), ratios.end());
    return ratios[ratios.size() / 2];
}

std::vector<Timing> race(gpu::Context& context, std::span<const Entrant> entrants, int repeat) {
    std::vector<Timing> timings(entrants.size());
    std::vector<std::unique_ptr<render::Renderer>> renderers(entrants.size());
    double round = 0;
    for (std::size_t k = 0; k < entrants.size(); ++k) {
        const auto& [on, setting] = entrants[k];
        try {
            renderers[k] = std::make_unique<render::Renderer>(
                context, accuracy::apply(setting, on->subject.scene),
                render::RenderOptions{on->width(), on->height(), {}, {}});
            // Drivers make their code at the first draw, of which no time is kept.
            for (const scene::SceneAt& now : on->frames) {
                render::Picture picture = renderers[k]->draw(now);
                timings[k].evaluations += double(picture.evaluations());
                round += ms(picture);
                renderers[k]->reuse(std::move(picture));
            }
        } catch (const std::exception& error) {
            renderers[k].reset();
            timings[k].refused = error.what();
        }
    }
    const int rounds = std::clamp(int(minute / std::max(round, 1.0)), 1, repeat);
    const std::size_t frames = entrants.front().on->frames.size();
    for (Timing& timing : timings) timing.rounds.assign(std::size_t(rounds), 0);
    for (std::size_t frame = 0; frame < frames; ++frame) {
        std::vector<std::vector<double>> times(entrants.size());
        for (int again = 0; again < rounds; ++again) {
            for (std::size_t turn = 0; turn < entrants.size(); ++turn) {
                const std::size_t k = (turn + std::size_t(again)) % entrants.size();
                if (!renderers[k]) continue;
                render::Picture picture = renderers[k]->draw(entrants[k].on->frames[frame]);
                times[k].push_back(ms(picture));
                timings[k].rounds[std::size_t(again)] += times[k].back();
                renderers[k]->reuse(std::move(picture));
            }
        }
        for (std::size_t k = 0; k < entrants.size(); ++k) {
            if (!renderers[k]) continue;
            std::sort(times[k].begin(), times[k].end());
            const double median = times[k][times[k].size() / 2];
            timings[k].ms += median / double(frames);
            timings[k].spread =
                std::max(timings[k].spread, (times[k].back() - times[k].front()) / median);
        }
    }
    return timings;
}

Certified without_bounds(const Certified& on) {
    Certified empty{on.subject, on.frames, {}};
    empty.subject.scene.surfaces[0].isolation.beam = false;
    for (scene::SceneAt& now : empty.frames) {
        const glm::dvec3 away = 1e3 * now.surfaces[0].bounds.radius * now.camera.up;
        now.surfaces[0].bounds.min += away;
        now.surfaces[0].bounds.max += away;
        now.surfaces[0].bounds.centre += away;
    }
    return empty;
}

Contest hold(gpu::Context& context, const Certified& on, std::span<const scene::Method> methods,
             int most_halvings, int repeat) {
    const scene::Scene& scene = on.subject.scene;
    Contest contest{on.subject.name,
                    on.width(),
                    int(on.frames.size()),
                    scene.surfaces[0].isolation.step,
                    {},
                    {}};
    Ladder ladder(context, on, most_halvings);
    const Certified empty = without_bounds(on);
    std::vector<Entrant> entrants{{&empty, setting(scene, scene::Method::amp_sign)}};
    std::map<int, std::size_t> racing; // halvings of the sign test -> place among the entrants
    const auto enter_sign_test = [&](int halvings) {
        if (racing.try_emplace(halvings, entrants.size()).second) {
            entrants.push_back({&on, setting(scene, scene::Method::amp_sign, halvings)});
        }
    };
    enter_sign_test(0);
    std::vector<std::size_t> place(methods.size(), 0);
    for (std::size_t k = 0; k < methods.size(); ++k) {
        Standing standing{methods[k], {}, {}, {}};
        try {
            const bool is_sign_test = methods[k] == scene::Method::amp_sign;
            standing.count =
                is_sign_test ? ladder.at(0) : count(context, on, setting(scene, methods[k]));
            const auto rung = ladder.as_right_as(standing.count.errors.wrong());
            standing.halvings = rung.halvings;
            standing.reached = rung.reached;
            enter_sign_test(rung.halvings);
            place[k] = racing.at(0);
            if (!is_sign_test) {
                place[k] = entrants.size();
                entrants.push_back({&on, setting(scene, methods[k])});
            }
        } catch (const std::exception& error) {
            standing.refused = error.what();
        }
        contest.standings.push_back(std::move(standing));
    }
    const std::vector<Timing> timings = race(context, entrants, repeat);
    contest.empty = timings.front();
    for (std::size_t k = 0; k < methods.size(); ++k) {
        Standing& standing = contest.standings[k];
        if (!standing.refused.empty()) continue;
        standing.timing = timings[place[k]];
        standing.refused = standing.timing.refused;
        if (!standing.refused.empty()) continue;
        const double frames = double(on.frames.size());
        standing.operations = operations(scene, methods[k]) * standing.count.evaluations / frames /
                              (1e-3 * standing.timing.ms);
        standing.against_own = ratio(timings[racing.at(0)], standing.timing);
        const Timing& equal = timings[racing.at(standing.halvings)];
        standing.against_equal = ratio(equal, standing.timing);
        standing.at_most = ratio(equal, contest.empty);
    }
    return contest;
}

} // namespace isomotion::bench

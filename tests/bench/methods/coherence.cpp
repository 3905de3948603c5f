#include "methods/coherence.h"

#include <algorithm>
#include <chrono>

namespace isomotion::bench {
namespace {

using shader::Channel;

constexpr std::array every_known{Known::nothing, Known::by_pixel, Known::last_starts,
                                 Known::own_starts, Known::own_by_pixel};

bool is_anew(Known known) { return known == Known::nothing || known == Known::by_pixel; }
bool is_by_pixel(Known known) { return known == Known::own_by_pixel || known == Known::by_pixel; }

// Draws frames of a subject with what is known of them.
class Frames {
public:
    Frames(gpu::Context& context, const Certified& on, Known known,
           std::vector<Channel> channels = {})
        : on_(on)
        , known_(known)
        , scene_(drawn(on, known))
        , renderer_(context, scene_, options(std::move(channels))) {}

    render::Picture draw(std::size_t k) {
        if (is_anew(known_)) return renderer_.draw(on_.frames[k]);
        // Only the frame before leaves other starts than are there already.
        if (known_ == Known::last_starts || starts_of_ != int(k)) {
            renderer_.keep_beams(false);
            renderer_.reuse(
                renderer_.draw(known_ == Known::last_starts ? before(k) : on_.frames[k]));
            renderer_.keep_beams(true);
            starts_of_ = int(k);
        }
        return renderer_.draw(on_.frames[k]);
    }
    void reuse(render::Picture picture) { renderer_.reuse(std::move(picture)); }
    const scene::Scene& scene() const { return scene_; }

private:
    static scene::Scene drawn(const Certified& on, Known known) {
        scene::Scene scene = on.subject.scene;
        scene.surfaces[0].isolation.method = scene::Method::hermite;
        if (known != Known::nothing) scene.surfaces[0].isolation.beam = true;
        return scene;
    }
    render::RenderOptions options(std::vector<Channel> channels) const {
        render::RenderOptions options{on_.width(), on_.height(), std::move(channels), {}};
        if (is_by_pixel(known_)) options.finest_beam = 1;
        return options;
    }
    // In a loop the first frame comes after the second, seen backwards.
    scene::SceneAt before(std::size_t k) const {
        const int frame = on_.subject.frames[k];
        return scene::in_formula_coordinates(
            scene::at_frame(scene_, frame > 1 ? frame - 1 : frame + 1));
    }

    const Certified& on_;
    Known known_;
    scene::Scene scene_;
    render::Renderer renderer_;
    int starts_of_ = -1;
};

Count count(gpu::Context& context, const Certified& on, Known known) {
    Frames frames(context, on, known, {Channel::normal, Channel::position, Channel::verdict});
    Count found;
    for (std::size_t k = 0; k < on.frames.size(); ++k) {
        const render::Picture picture = frames.draw(k);
        found.evaluations += double(picture.evaluations());
        found.errors.add(accuracy::compare(on.frames[k], picture.frame, on.truths[k]));
    }
    found.errors.depth.clear();
    found.errors.normal.clear();
    return found;
}

} // namespace

const char* name(Known known) {
    switch (known) {
    case Known::nothing:
        return "nothing: all anew";
    case Known::by_pixel:
        return "nothing, starts by pixel";
    case Known::last_starts:
        return "starts of the frame before, unproved";
    case Known::own_starts:
        return "its own starts";
    case Known::own_by_pixel:
        return "its own starts, by pixel";
    }
    return "?";
}

Coherence coherence(gpu::Context& context, const Certified& on, int repeat) {
    Coherence result{on.subject.name, on.width(), int(on.frames.size()), {}};
    std::vector<std::unique_ptr<Frames>> racing;
    for (const Known known : every_known) {
        result.rows.push_back({known, count(context, on, known), {}});
        result.rows.back().timing.rounds.assign(std::size_t(repeat), 0);
        racing.push_back(std::make_unique<Frames>(context, on, known));
        racing.back()->reuse(racing.back()->draw(0)); // drivers make their code
    }
    const double frames = double(on.frames.size());
    for (std::size_t k = 0; k < on.frames.size(); ++k) {
        std::vector<std::vector<double>> times(racing.size());
        for (int again = 0; again < repeat; ++again) {
            for (std::size_t turn = 0; turn < racing.size(); ++turn) {
                const std::size_t r = (turn + std::size_t(again)) % racing.size();
                render::Picture picture = racing[r]->draw(k);
                times[r].push_back(1e3 * picture.drawing.count());
                result.rows[r].timing.rounds[std::size_t(again)] += times[r].back();
                racing[r]->reuse(std::move(picture));
            }
        }
        for (std::size_t r = 0; r < racing.size(); ++r) {
            Timing& timing = result.rows[r].timing;
            std::sort(times[r].begin(), times[r].end());
            const double median = times[r][times[r].size() / 2];
            timing.ms += median / frames;
            timing.spread = std::max(timing.spread, (times[r].back() - times[r].front()) / median);
        }
    }
    for (Carried& row : result.rows) row.gain = ratio(result.rows.front().timing, row.timing);
    return result;
}

} // namespace isomotion::bench

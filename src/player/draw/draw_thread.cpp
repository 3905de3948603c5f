#include "player/draw/draw_thread.h"

#include <algorithm>
#include <bit>
#include <list>
#include <numeric>
#include <random>

#include "gpu/error.h"
#include "render/exposure.h"
#include "render/renderer.h"
#include "shader/finding_elements.h"

namespace isomotion::player {
namespace {

using Clock = std::chrono::steady_clock;

// Two methods side by side, each for small pictures and for large ones.
constexpr std::size_t most_renderers = 4;

RayCounts counts_of(const render::Picture& picture) {
    return {picture.verdicts, picture.evaluations(), picture.drawing};
}

// Renderers are made for one tile of so many pixels, and pictures cut into such: between two the
// window can draw, and a draw be given up. A multiple of the beams' squares.
constexpr int tile_side = 256;

bool is_lost(const gpu::Context& context) {
    try {
        context.expect_alive();
        return false;
    } catch (const gpu::ContextLost&) {
        return true;
    }
}

} // namespace

std::int64_t RayCounts::rays() const {
    return std::accumulate(verdicts.begin(), verdicts.end(), std::int64_t(0));
}

class DrawThread::Work {
public:
    Work(DrawThread& thread, gpu::Context& context)
        : thread_(thread)
        , context_(context) {}

    void forget_renderers() { renderers_.clear(); }
    void forget_shaders() {
        renderers_.clear();
        broken_.reset();
    }

    void draw(const Request& request, Clock::time_point begin) {
        begin_ = begin;
        Shown shown = blank(request);
        render::Exposure exposure, other_exposure;
        std::optional<RaysToAudit> rays;
        for (std::size_t k = 0; k < request.samples.size(); ++k) {
            const Sample& sample = request.samples[k];
            render::Picture drawn =
                picture(request, request.isolation, sample, shown, k == 0 ? request.audited : 0);
            if (!drawn.endings.empty()) rays = rays_to_audit(request, std::move(drawn.endings));
            exposure.add(std::move(drawn));
            shown.counts = last_;
            if (request.other) {
                other_exposure.add(picture(request, *request.other, sample, shown));
                shown.other = last_;
            }
            const bool is_last = k + 1 == request.samples.size();
            if (!is_last && !std::has_single_bit(k + 1)) continue;
            shown.samples = int(k) + 1;
            develop(exposure, other_exposure, shown);
            shown.took = Clock::now() - begin;
            if (is_last) {
                shown.rays = std::move(rays);
                thread_.give(std::move(shown));
                return;
            }
            thread_.give(Shown(shown));
            shown.compiled = false;
        }
    }

private:
    static std::int64_t pixels_of(const Request& request) {
        return std::int64_t(request.width) * request.height;
    }

    struct Kept {
        std::shared_ptr<const scene::Scene> scene;
        scene::Isolation isolation;
        std::vector<shader::Channel> channels;
        std::vector<std::int64_t> sizes_of_change = {}; // of pictures' shaders
        std::ptrdiff_t size_class = 0;                  // how many of them pictures reach
        std::unique_ptr<render::Renderer> renderer = {};
        std::string error = {}; // instead of a renderer

        bool serves(const Request& request, const scene::Isolation& wanted,
                    const std::vector<shader::Channel>& layers) const {
            return scene == request.scene && isolation.method == wanted.method &&
                   isolation.beam == wanted.beam && isolation.certify == wanted.certify &&
                   channels == layers && size_class == size_class_of(request);
        }
        std::ptrdiff_t size_class_of(const Request& request) const {
            return std::ranges::count_if(
                sizes_of_change, [&](std::int64_t size) { return pixels_of(request) >= size; });
        }
    };

    static Shown blank(const Request& request) {
        Shown shown;
        shown.number = request.number;
        shown.asked_at = request.asked_at;
        shown.frame = request.frame;
        shown.now = request.samples.front().now;
        shown.scale = request.scale;
        shown.view = request.view;
        shown.asked = int(request.samples.size());
        return shown;
    }

    static RaysToAudit rays_to_audit(const Request& request, std::vector<render::Ending> endings) {
        // Endings come tile by tile; an audit may end before it has held them all.
        std::ranges::shuffle(endings, std::mt19937_64(std::uint64_t(request.frame)));
        const Sample& sample = request.samples.front();
        return {request.number, request.scene, sample.now,     sample.aim,
                request.frame,  request.width, request.height, std::move(endings)};
    }

    render::Picture picture(const Request& request, const scene::Isolation& isolation,
                            const Sample& sample, Shown& shown, int audited = 0) {
        dropped_ = {};
        render::Renderer& renderer = renderer_for(request, isolation, shown);
        renderer.adjust(isolation);
        renderer.resize(request.width, request.height);
        dropped_ = [this, &request] { return thread_.superseded(request, begin_); };
        render::PictureInputs inputs = renderer.prepare(*sample.now, sample.aim);
        inputs.endings_of =
            audit::pixels_of_frame(request.width, request.height, audited, int(request.frame));
        render::Picture drawn = renderer.draw(inputs);
        dropped_ = {};
        context_.expect_alive();
        if (drawn.compiled) shown.compiled = true;
        last_ = counts_of(drawn);
        return drawn;
    }

    render::Renderer& renderer_for(const Request& request, const scene::Isolation& isolation,
                                   Shown& shown) {
        const auto channels = channels_of(request.view);
        const auto found = std::ranges::find_if(renderers_, [&](const Kept& kept) {
            return kept.serves(request, isolation, channels);
        });
        if (found != renderers_.end()) {
            renderers_.splice(renderers_.begin(), renderers_, found);
            return *found->renderer;
        }
        // It would fail again at every frame.
        if (broken_ && broken_->serves(request, isolation, channels)) {
            throw std::runtime_error(broken_->error);
        }
        // Those of a scene that is no longer shown are of no use to it.
        renderers_.remove_if([&](const Kept& kept) { return kept.scene != request.scene; });
        while (renderers_.size() >= most_renderers) renderers_.pop_back();
        shown.compiled = true;
        thread_.say_compiling(true);
        scene::Scene scene = *request.scene;
        scene.surfaces.front().isolation = isolation;
        Kept made{.scene = request.scene,
                  .isolation = isolation,
                  .channels = channels,
                  .sizes_of_change = shader::sizes_of_change(
                      scene, {.writes_buffers = context_.info().has(4, 3)})};
        made.size_class = made.size_class_of(request);
        const auto breaks = [&](const std::exception& error) {
            made.error = error.what();
            made.renderer.reset();
            broken_ = std::move(made);
        };
        try {
            made.renderer = compile(scene, request, !made.sizes_of_change.empty());
            // Drivers translate at the first draw.
            made.renderer->resize(16, 16);
            made.renderer->draw(*request.samples.front().now);
        } catch (const gpu::CompileError& error) {
            breaks(error);
            throw;
        } catch (const std::length_error& error) {
            breaks(error);
            throw;
        }
        thread_.say_compiling(false);
        renderers_.push_front(std::move(made));
        return *renderers_.front().renderer;
    }

    std::unique_ptr<render::Renderer> compile(const scene::Scene& scene, const Request& request,
                                              bool by_size) {
        render::RenderOptions options;
        options.width = options.height = tile_side;
        if (by_size) options.pixels = pixels_of(request);
        options.channels = channels_of(request.view);
        options.tells_endings = true;
        options.stop = [this] { return dropped_ && dropped_(); };
        return std::make_unique<render::Renderer>(context_, scene, std::move(options));
    }

    void develop(const render::Exposure& exposure, const render::Exposure& other_exposure,
                 Shown& shown) const {
        const render::Picture first = exposure.mean();
        if (shown.view == View::difference && other_exposure.count() > 0) {
            const render::Picture second = other_exposure.mean();
            shown.left = player::shaded(first.frame);
            shown.right = player::shaded(second.frame);
            shown.difference = player::difference(first.frame, second.frame);
            shown.raster = std::move(shown.difference->raster);
            return;
        }
        if (shown.view == View::evaluations) {
            shown.heat_end = player::heat_end(first.frame);
            shown.raster = player::evaluations(first.frame, shown.heat_end);
            return;
        }
        shown.raster = player::shown(shown.view, first.frame);
    }

    DrawThread& thread_;
    gpu::Context& context_;
    std::list<Kept> renderers_;  // the one used last first
    std::optional<Kept> broken_; // did not compile
    Clock::time_point begin_;    // of the request
    std::function<bool()> dropped_;
    RayCounts last_;
};

DrawThread::DrawThread(gpu::Context& context, std::function<void()> wake)
    : context_(context)
    , wake_(std::move(wake))
    , thread_([this] { run(); }) {}

DrawThread::~DrawThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

void DrawThread::draw(Request request) {
    {
        const std::lock_guard lock(mutex_);
        request_ = std::move(request);
    }
    wanted_.notify_one();
}

std::optional<Shown> DrawThread::take_shown() {
    const std::lock_guard lock(mutex_);
    return std::exchange(shown_, std::nullopt);
}

std::optional<Failure> DrawThread::take_failure() {
    const std::lock_guard lock(mutex_);
    return std::exchange(failure_, std::nullopt);
}

void DrawThread::forget_shaders() {
    const std::lock_guard lock(mutex_);
    forget_ = true;
}

std::optional<GivenUp> DrawThread::take_given_up() {
    const std::lock_guard lock(mutex_);
    return std::exchange(given_up_, std::nullopt);
}

std::optional<Clock::time_point> DrawThread::compiling_since() const {
    const std::lock_guard lock(mutex_);
    return compiling_;
}

bool DrawThread::lost() const {
    const std::lock_guard lock(mutex_);
    return lost_;
}

void DrawThread::say_lost() {
    {
        const std::lock_guard lock(mutex_);
        lost_ = true;
    }
    wake_();
}

bool DrawThread::superseded(const Request& request, Time begin) const {
    const std::lock_guard lock(mutex_);
    if (ending_) return true;
    return request_ && (request.may_be_dropped || Clock::now() - begin > patience_);
}

void DrawThread::give_up(const Request& request, Time begin) {
    if (request.may_be_dropped) return;
    {
        const std::lock_guard lock(mutex_);
        patience_ *= 2;
        given_up_ = GivenUp{request.number, request.scale, Clock::now() - begin};
    }
    wake_();
}

void DrawThread::say_compiling(bool compiling) {
    {
        const std::lock_guard lock(mutex_);
        compiling_ = compiling ? std::optional(Clock::now()) : std::nullopt;
    }
    wake_();
}

void DrawThread::give(Shown shown) {
    {
        const std::lock_guard lock(mutex_);
        if (shown.samples == shown.asked) patience_ = least_patience;
        shown_ = std::move(shown);
        failure_.reset();
    }
    wake_();
}

void DrawThread::fail(const Request& request, const std::string& text) {
    {
        const std::lock_guard lock(mutex_);
        failure_ = Failure{request.number, text};
        compiling_.reset();
    }
    wake_();
}

void DrawThread::run() {
    try {
        context_.make_current();
    } catch (const std::runtime_error& error) {
        fail({}, error.what());
        return;
    }
    {
        Work work(*this, context_);
        for (;;) {
            std::unique_lock lock(mutex_);
            wanted_.wait(lock, [&] { return ending_ || request_; });
            if (ending_) break;
            const std::optional<Request> taken = std::exchange(request_, std::nullopt);
            if (!taken) continue;
            const Request& request = *taken;
            const bool forget = std::exchange(forget_, false);
            lock.unlock();
            const auto begin = Clock::now();
            try {
                if (forget) work.forget_shaders();
                work.draw(request, begin);
            } catch (const render::Stopped&) {
                give_up(request, begin);
            } catch (const gpu::ContextLost&) {
                say_lost();
                break;
            } catch (const std::bad_alloc&) {
                fail(request, "out of memory: the picture is too large for this machine");
            } catch (const std::exception& error) {
                // A reset shows as the failure of other calls, too.
                if (is_lost(context_)) {
                    say_lost();
                    break;
                }
                work.forget_renderers();
                fail(request, error.what());
            }
        }
    }
    context_.release();
}

} // namespace isomotion::player

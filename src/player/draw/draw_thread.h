// Draws pictures in a thread of its own, so that neither the compilation of a shader nor a long
// draw blocks the window.
//
// At most one request is pending; a newer one replaces it. So the thread lags by at most the
// picture that it draws. Likewise a newer picture replaces one that was not taken.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gpu/context.h"
#include "player/draw/audit_thread.h"
#include "player/draw/views.h"
#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// One of the pictures that are averaged.
struct Sample {
    std::shared_ptr<const scene::SceneAt> now; // shared where nothing moves from one to the next
    scene::Aim aim;
};

// The picture to be drawn. Renderers are kept by `scene` (its address), method, channels and, where
// shaders depend on it, a class of sizes, so nothing is compiled for another time, camera or value.
struct Request {
    std::uint64_t number = 0;
    std::shared_ptr<const scene::Scene> scene;
    scene::Isolation isolation;
    std::optional<scene::Isolation> other; // View::difference compares with it
    int width = 0, height = 0;
    double scale = 1; // relative to the size that fits the window
    View view = View::shaded;
    std::int64_t frame = 1;
    // At least one. The mean is shown after the first, then each time their number doubles.
    std::vector<Sample> samples;
    int audited = 0; // number of the first sample's rays that are returned with the last picture
    // Whether a newer request ends it at once. Otherwise it is ended only if it takes too long.
    bool may_be_dropped = false;
    std::chrono::steady_clock::time_point asked_at{}; // time of the first change that it shows
};

// Counts of one method's rays, for display.
struct RayCounts {
    std::array<std::int64_t, 5> verdicts{}; // rays by render::Verdict
    std::int64_t evaluations = 0;
    std::chrono::duration<double> drawing{};

    std::int64_t rays() const;
};

struct Shown {
    std::uint64_t number = 0; // of the request
    std::int64_t frame = 1;
    std::shared_ptr<const scene::SceneAt> now; // at the frame, and its camera
    double scale = 1;
    View view = View::shaded;
    int samples = 0;                      // number of pictures averaged
    int asked = 0;                        // number of pictures requested
    Raster raster;                        // in View::difference, where the methods differ
    Raster left, right;                   // View::difference: the picture of each method
    RayCounts counts;                     // of one picture
    RayCounts other;                      // by the other method
    std::optional<Difference> difference; // its raster is empty
    double heat_end = 0;                  // evaluations at the end of the heat map
    std::optional<RaysToAudit> rays;      // where some of the first sample's rays ended
    std::chrono::steady_clock::time_point asked_at{};
    std::chrono::duration<double> took{}; // since the previous picture was finished
    bool compiled = false; // a shader was compiled, so `took` doesn't predict the next picture
};

// A picture that was given up after this time because of a newer request.
struct GivenUp {
    std::uint64_t number = 0;
    double scale = 1;
    std::chrono::duration<double> took{};
};

// The reason why there is no picture.
struct Failure {
    std::uint64_t number = 0;
    std::string text;
};

class DrawThread {
public:
    // Draws in `context`, which must not be current anywhere and must outlive the thread. The
    // thread calls `wake` when there is something to take.
    DrawThread(gpu::Context& context, std::function<void()> wake);
    ~DrawThread(); // waits for the pass being drawn
    DrawThread(const DrawThread&) = delete;
    DrawThread& operator=(const DrawThread&) = delete;

    void draw(Request request);
    std::optional<Shown> take_shown();
    std::optional<Failure> take_failure();
    std::optional<GivenUp> take_given_up();
    // Whether the driver was reset; then no more pictures come.
    bool lost() const;
    // Makes the next request compile again, after shader files have changed.
    void forget_shaders();

    // The start time of the compilation in progress.
    std::optional<std::chrono::steady_clock::time_point> compiling_since() const;

private:
    class Work; // objects that only the thread uses: renderers

    void run();
    using Time = std::chrono::steady_clock::time_point;
    // Called between tiles and passes.
    bool superseded(const Request& request, Time begin) const;
    void give(Shown shown);
    void give_up(const Request& request, Time begin);
    void fail(const Request& request, const std::string& text);
    void say_compiling(bool compiling);
    void say_lost();

    gpu::Context& context_;
    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable wanted_;
    std::optional<Request> request_;
    std::optional<Shown> shown_;
    std::optional<Failure> failure_;
    std::optional<GivenUp> given_up_;
    std::optional<std::chrono::steady_clock::time_point> compiling_;
    bool ending_ = false, forget_ = false, lost_ = false;
    // The time that a picture may take while a newer request waits. It doubles with each picture
    // given up in a row, so that one is finished eventually, however long each takes.
    std::chrono::duration<double> patience_ = least_patience;
    static constexpr std::chrono::duration<double> least_patience{0.5};
    std::thread thread_; // last: it uses all of the above
};

} // namespace isomotion::player

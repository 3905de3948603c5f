// Draws pictures on a thread of its own, so that neither a shader's compilation nor a long draw
// holds the window up.
//
// One request is pending at most: a newer one replaces it, so the thread is never behind by more
// than the picture it draws. Pictures come back the same way: a newer one replaces one not taken.
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

// One of the pictures whose mean is shown.
struct Sample {
    std::shared_ptr<const scene::SceneAt> now; // shared where nothing moves from one to the next
    scene::Aim aim;
};

// What is to be drawn. Renderers are kept by `scene` (its address), method and channels: nothing is
// compiled for a new moment, camera, size or value.
struct Request {
    std::uint64_t number = 0;
    std::shared_ptr<const scene::Scene> scene;
    scene::Isolation isolation;
    std::optional<scene::Isolation> other; // View::difference compares with it
    int width = 0, height = 0;
    double scale = 1; // of the size that the window has room for
    View view = View::shaded;
    std::int64_t frame = 1;
    // At least one. The mean is shown after the first, then each time their number doubles.
    std::vector<Sample> samples;
    int audited = 0; // so many rays of the first are given back with the last picture
    // A newer request ends it at once. Otherwise only when it takes too long.
    bool may_be_dropped = false;
    std::chrono::steady_clock::time_point asked_at{}; // the first change that it shows
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
    double scale = 1;
    View view = View::shaded;
    int samples = 0;                      // the mean of so many pictures
    int asked = 0;                        // of so many that were requested
    Raster raster;                        // in View::difference, where the methods differ
    Raster left, right;                   // View::difference: the picture of each method
    RayCounts counts;                     // of one picture
    RayCounts other;                      // by the other method
    std::optional<Difference> difference; // its raster is empty
    double heat_end = 0;                  // evaluations at the end of the heat map
    std::optional<RaysToAudit> rays;      // where some of the first sample's ended
    std::chrono::steady_clock::time_point asked_at{};
    std::chrono::duration<double> took{}; // since the picture before was done
    bool compiled = false; // a shader was, so `took` says nothing of the next picture
};

// A picture that was given up after this time, for a newer request.
struct GivenUp {
    std::uint64_t number = 0;
    double scale = 1;
    std::chrono::duration<double> took{};
};

// Why there is no picture.
struct Failure {
    std::uint64_t number = 0;
    std::string text;
};

class DrawThread {
public:
    // Draws in `context`, which is current nowhere and outlives the thread. Calls `wake`, from the
    // thread, when there is something to take.
    DrawThread(gpu::Context& context, std::function<void()> wake);
    ~DrawThread(); // waits for the pass being drawn
    DrawThread(const DrawThread&) = delete;
    DrawThread& operator=(const DrawThread&) = delete;

    void draw(Request request);
    std::optional<Shown> take_shown();
    std::optional<Failure> take_failure();
    std::optional<GivenUp> take_given_up();
    // Whether the driver was reset: no more pictures come.
    bool lost() const;
    // Compiles anew at the next request, since shader files have changed.
    void forget_shaders();

    // When the compilation that is under way began.
    std::optional<std::chrono::steady_clock::time_point> compiling_since() const;

private:
    class Work; // what only the thread uses: renderers

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
    // A picture may take so long while a newer request waits. Doubles with each picture given up in
    // a row, so that one is finished in the end, however long each takes.
    std::chrono::duration<double> patience_ = least_patience;
    static constexpr std::chrono::duration<double> least_patience{0.5};
    std::thread thread_; // last: it uses all of the above
};

} // namespace isomotion::player

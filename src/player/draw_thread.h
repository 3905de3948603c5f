// Pictures drawn on a thread of their own, so that neither a shader's compilation nor a long draw
// holds the window up.
//
// There is one place for what is to be drawn: a newer request takes an unstarted one's, so the
// thread is never behind by more than the picture it draws. Pictures come back the same way: who
// takes none gets the newest.
#pragma once

#include <chrono>
#include <condition_variable>
#include <cstdint>
#include <exception>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "gpu/context.h"
#include "player/views.h"
#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// One picture of those whose mean is shown.
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
    std::optional<scene::Isolation> other; // of the view that holds two methods side by side
    int width = 0, height = 0;
    double scale = 1; // of the size that the window has room for
    View view = View::shaded;
    std::int64_t frame = 1;
    // At least one; means are shown after the first and then as their number doubles.
    std::vector<Sample> samples;
    // Given up for a newer request at once; what moves only when it takes too long.
    bool may_be_dropped = false;
    std::chrono::steady_clock::time_point asked_at{}; // when the first of what is new in it came
};

// What a method's rays went through, for reading out.
struct Tally {
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
    int samples = 0; // of `asked`, whose mean this is
    int asked = 0;
    Raster raster;                        // in the view of two methods what sets them apart
    Raster left, right;                   // of that view: what each drew
    Tally tally;                          // of one picture
    Tally other;                          // of the other method
    std::optional<Difference> difference; // its raster is empty
    double heat_end = 0;                  // of the evaluations' colours
    std::chrono::steady_clock::time_point asked_at{};
    std::chrono::duration<double> took{}; // all of it, once the picture before was done
    bool compiled = false; // for this picture: its time says nothing of the next one's
};

// A picture of what moves that was given up: it would have taken longer than this.
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
    // Draws in `context`, which is current nowhere and outlives the thread.
    explicit DrawThread(gpu::Context& context);
    ~DrawThread(); // waits for the pass being drawn
    DrawThread(const DrawThread&) = delete;
    DrawThread& operator=(const DrawThread&) = delete;

    void draw(Request request);
    std::optional<Shown> take_shown();
    std::optional<Failure> take_failure();
    std::optional<GivenUp> take_given_up();
    // The driver was reset: no more pictures come.
    bool lost() const;
    // Shader files have changed: the next request compiles anew.
    void forget_shaders();

    // Since when a shader is compiled.
    std::optional<std::chrono::steady_clock::time_point> compiling_since() const;

private:
    class Work; // the thread's own: renderers

    void run();
    using Time = std::chrono::steady_clock::time_point;
    // Asked between tiles and passes.
    bool superseded(const Request& request, Time begin) const;
    void give(Shown shown);
    void give_up(const Request& request, Time begin);
    void fail(const Request& request, const std::string& text);
    void say_compiling(bool compiling);
    void say_lost();

    gpu::Context& context_;
    mutable std::mutex mutex_;
    std::condition_variable wanted_;
    std::optional<Request> request_;
    std::optional<Shown> shown_;
    std::optional<Failure> failure_;
    std::optional<GivenUp> given_up_;
    std::optional<std::chrono::steady_clock::time_point> compiling_;
    bool ending_ = false, forget_ = false, lost_ = false;
    // What moves may take so long while a newer request waits. It doubles with each picture given
    // up in a row, so that one is finished in the end, however long each takes.
    std::chrono::duration<double> patience_ = least_patience;
    static constexpr std::chrono::duration<double> least_patience{0.5};
    std::thread thread_; // last: it uses all of the above
};

} // namespace isomotion::player

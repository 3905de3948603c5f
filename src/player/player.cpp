#include "player/player.h"

#include <algorithm>
#include <chrono>

#include <fmt/format.h>
#include <imgui.h>

#include "player/draw_thread.h"
#include "player/easel.h"
#include "player/memory.h"
#include "player/notices.h"
#include "player/picture_area.h"
#include "player/picture_log.h"
#include "player/session.h"
#include "player/shortcuts.h"
#include "player/theme.h"
#include "player/transport.h"
#include "player/window.h"
#include "scene/error.h"

namespace isomotion::player {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ImGuiWindowFlags plain_window =
    ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings |
    ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNavInputs |
    ImGuiWindowFlags_NoNavFocus;

class Player {
public:
    explicit Player(const PlayOptions& options)
        : log_(options.log)
        , window_("isomotion", std::nullopt)
        , drawing_(open_drawing())
        , thread_(*drawing_)
        , easel_(thread_) {
        open(options);
    }

    void run() {
        while (!window_.closing()) {
            window_.wait(sleep());
            take_pictures();
            obey_keys();
            if (!window_.stale() && !new_picture_ && !compiling()) {
                ask();
                continue;
            }
            show();
            ask();
        }
    }

private:
    // Beside the window's, whose functions were loaded before; the thread makes it current.
    std::unique_ptr<gpu::Context> open_drawing() {
        try {
            auto context = gpu::Context::create(gpu::Backend::glfw);
            window_.make_current();
            return context;
        } catch (const gpu::Unavailable& error) {
            throw NoWindow(error.what());
        }
    }

    void open(const PlayOptions& options) {
        session_.emplace(scene::load(options.scene, options.overrides));
        if (options.playing) session_->playback = played(session_->playback, now());
        easel_.begin_scene();
        window_.set_title(session_->scene().title + " - isomotion");
    }

    double now() const { return std::chrono::duration<double>(Clock::now() - begin_).count(); }

    bool compiling() const { return thread_.compiling_since().has_value(); }

    // Seconds that nothing has to be done for; below 0: until an event comes.
    double sleep() const {
        constexpr double progress = 0.1;
        double until = -1;
        const auto sooner = [&](double seconds) {
            seconds = std::max(0.0, seconds);
            until = until < 0 ? seconds : std::min(until, seconds);
        };
        if (compiling()) sooner(progress);
        if (session_) {
            if (const auto at = next_change(session_->playback, now())) sooner(*at - now());
        }
        if (const auto at = easel_.next_change()) sooner(*at - now());
        return until;
    }

    void take_pictures() {
        if (auto shown = thread_.take_shown()) {
            easel_.learn(*shown);
            window_.make_current();
            area_.take(std::move(*shown));
            notices_.draw_error.clear();
            new_picture_ = true;
        }
        if (auto failure = thread_.take_failure()) {
            notices_.draw_error = failure->text;
            log_.add_failure(failure->text);
            window_.refresh();
        }
    }

    void obey_keys() {
        for (const KeyPress& key : window_.take_keys()) {
            if (ImGui::GetIO().WantTextInput) continue;
            const auto command = command_of(key);
            if (command) obey(*command);
        }
    }

    void obey(Command command) {
        if (command == Command::quit) return window_.close();
        if (command == Command::full_screen) return window_.toggle_full_screen();
        if (command == Command::help) {
            notices_.help = !notices_.help;
            return;
        }
        if (command == Command::dismiss) {
            notices_.help = false;
            return;
        }
        if (!session_) return;
        Playback& playback = session_->playback;
        switch (command) {
        case Command::toggle:
            playback = toggled(playback, now());
            break;
        case Command::forward:
            playback = stepped(playback, 1, now());
            break;
        case Command::back:
            playback = stepped(playback, -1, now());
            break;
        case Command::first:
            playback = scrubbed(playback, playback.first, now());
            break;
        case Command::last:
            playback = scrubbed(playback, playback.last, now());
            break;
        case Command::faster:
            playback = with_speed(playback, playback.doublings + 1, now());
            break;
        case Command::slower:
            playback = with_speed(playback, playback.doublings - 1, now());
            break;
        case Command::loop:
            playback = with_loop(playback, !playback.loop, now());
            break;
        default:
            break;
        }
    }

    void show() {
        if (!window_.begin_frame()) return;
        const ImVec2 area = ImGui::GetIO().DisplaySize;
        const float bar = session_ ? Transport::height() : 0;
        show_picture({0, 0}, {area.x, area.y - bar});
        if (session_) show_transport({0, area.y - bar}, {area.x, bar});
        notices_.show(thread_.compiling_since());
        window_.end_frame();
        if (std::exchange(new_picture_, false) && area_.shown()) {
            log_.add(*area_.shown(), area_.corner(), area_.size(), easel_.at_rest());
        }
    }

    void show_picture(ImVec2 corner, ImVec2 size) {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0, 0, 0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        ImGui::Begin("picture", nullptr, plain_window | ImGuiWindowFlags_NoScrollWithMouse);
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
        ImGui::InvisibleButton("mouse", size,
                               ImGuiButtonFlags_MouseButtonLeft |
                                   ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        if (session_) {
            const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
            const scene::Output& output = session_->scene().output;
            const glm::ivec2 room(int(size.x * pixel.x), int(size.y * pixel.y));
            size_ = fitted_size(room, double(output.width) / output.height);
            steer();
            area_.show(size_);
        }
        ImGui::End();
    }

    void steer() {
        try {
            const std::int64_t frame = frame_at(session_->playback, now()).frame;
            const scene::CameraAt camera = session_->at(frame).camera;
            if (const auto moved = area_.steer(camera)) {
                Look look = session_->look();
                look.camera = *moved;
                session_->set(look);
            }
        } catch (const scene::SceneError&) { // told where it is drawn
        }
    }

    void show_transport(ImVec2 corner, ImVec2 size) {
        ImGui::SetNextWindowPos(corner);
        ImGui::SetNextWindowSize(size);
        ImGui::Begin("transport", nullptr, plain_window | ImGuiWindowFlags_NoScrollWithMouse);
        session_->playback = transport_.show(session_->playback, session_->scene().timeline,
                                             session_->key_marks(), now());
        ImGui::End();
    }

    void ask() {
        if (!session_ || size_.x < 1) return;
        session_->playback = settled(session_->playback, now());
        const std::int64_t frame = frame_at(session_->playback, now()).frame;
        try {
            easel_.ask(*session_, frame, size_, now(), !area_.held());
        } catch (const scene::SceneError& error) {
            if (notices_.draw_error != error.what()) window_.refresh();
            notices_.draw_error = error.what();
        }
    }

    Clock::time_point begin_ = Clock::now();
    PictureLog log_;
    Window window_;
    std::unique_ptr<gpu::Context> drawing_;
    DrawThread thread_;
    Easel easel_;
    std::optional<Session> session_;
    PictureArea area_;
    Transport transport_;
    Notices notices_;
    glm::ivec2 size_{0};
    bool new_picture_ = false;
};

} // namespace

void play(const PlayOptions& options) { Player(options).run(); }

} // namespace isomotion::player

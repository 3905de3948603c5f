#include "player/player.h"

#include <algorithm>
#include <chrono>
#include <utility>

#include <fmt/format.h>
#include <imgui.h>

#include "gpu/error.h"
#include "player/draw/audit_thread.h"
#include "player/draw/draw_thread.h"
#include "player/draw/frame_scheduler.h"
#include "player/model/camera_text.h"
#include "player/model/live_scene.h"
#include "player/model/memory.h"
#include "player/model/orbit.h"
#include "player/ui/gallery.h"
#include "player/ui/notices.h"
#include "player/ui/picture_area.h"
#include "player/ui/picture_log.h"
#include "player/ui/ring_overlay.h"
#include "player/ui/sections.h"
#include "player/ui/shortcuts.h"
#include "player/ui/topology_section.h"
#include "player/ui/transport.h"
#include "player/ui/window.h"
#include "scene/error.h"

namespace isomotion::player {
namespace {

using Clock = std::chrono::steady_clock;

constexpr ImGuiWindowFlags pane = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                  ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoMove |
                                  ImGuiWindowFlags_NoSavedSettings |
                                  ImGuiWindowFlags_NoBringToFrontOnFocus | ImGuiWindowFlags_NoNav;
constexpr ImGuiWindowFlags still_pane =
    pane | ImGuiWindowFlags_NoScrollbar | ImGuiWindowFlags_NoScrollWithMouse;

constexpr double files_every = 0.5;     // seconds between looks at files
constexpr double processes_every = 0.2; // and at processes that run
constexpr double progress_every = 0.1;
// A scene that has the driver reset as soon as it is drawn is not drawn once more.
constexpr auto lives_at_least = std::chrono::seconds(2);
// While pictures are drawn, widgets are drawn at these intervals: as events come, and otherwise.
// Both intervals grow, the latter to `least_widgets` at most, where widgets would take more than
// the parts of the time below.
constexpr double answers_every = 1.0 / 30, widgets_every = 0.1, least_widgets = 0.5;
constexpr double part_of_answers = 0.3, part_of_widgets = 0.1;
constexpr double newest = 0.2; // of a mean over draws

void begin_pane(const char* name, ImVec2 corner, ImVec2 size, ImGuiWindowFlags flags) {
    ImGui::SetNextWindowPos(corner);
    ImGui::SetNextWindowSize(size);
    ImGui::Begin(name, nullptr, flags);
}

class Player {
public:
    // Shows the scene, or the gallery without one. A scene that was played before goes on where it
    // was.
    Player(std::unique_ptr<LiveScene> scene, const PlayOptions& options, PictureLog& log)
        : reach_(options.reach)
        , memory_(options.remembers ? state_folder() : std::filesystem::path())
        , log_(log)
        , guard_(options.guard())
        , window_("isomotion", place(scene.get()))
        , drawing_(open_drawing())
        , thread_(*drawing_, Window::wake)
        , audits_(Window::wake)
        , scheduler_(thread_) {
        drawing_->keep_until_drawn(std::move(guard_));
        if (scene) {
            take(std::move(scene));
        } else {
            gallery_.open(memory_.opened());
        }
    }
    ~Player() { remember(); }

    // Runs until the window is closed. Throws gpu::ContextLost.
    void run() {
        while (!window_.closing()) {
            window_.wait(sleep());
            attend();
            obey_keys();
            const std::uint64_t shown = pictures_;
            if (window_.stale() || new_picture_ || compiling() || overdue()) show();
            // What came while a picture was put on the screen is to be in the next one.
            owes_ask_ = pictures_ != shown;
            if (!owes_ask_) ask();
        }
    }

    static void play(LiveScene& scene) {
        scene.session.playback = played(scene.session.playback, now());
    }

    // What was played, for another player.
    std::unique_ptr<LiveScene> take_scene() {
        remember();
        return std::move(scene_);
    }

private:
    std::optional<WindowPlace> place(const LiveScene* scene) const {
        if (scene) return memory_.recall(scene::reload_argument(scene->session.scene())).window;
        return std::nullopt;
    }

    // The draw thread's context. The window's comes first, as it loads GLFW's functions.
    std::unique_ptr<gpu::Context> open_drawing() {
        try {
            auto context = gpu::Context::create(gpu::Backend::glfw);
            window_.make_current();
            return context;
        } catch (const gpu::Unavailable& error) {
            throw NoWindow(error.what());
        }
    }

    // The same for every player: a scene may go from one to the next.
    static double now() {
        return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    }
    bool compiling() const { return thread_.compiling_since().has_value(); }
    bool processes_run() const {
        return export_.running() || topology_.running() || gallery_.rendering();
    }

    // ----- scenes

    void take(std::unique_ptr<LiveScene> scene) {
        remember();
        scene_ = std::move(scene);
        Session& session = scene_->session;
        if (!session.look().camera) {
            Look look = session.look();
            look.camera = memory_.recall(scene::reload_argument(session.scene())).camera;
            session.set(look);
        }
        if (session.scene().formula.empty())
            memory_.add_opened(std::filesystem::absolute(scene_->file()));
        scheduler_.begin_scene();
        gallery_.close();
        notices_.load_error.clear();
        notices_.draw_error.clear();
        window_.set_title(session.scene().title + " - isomotion");
        window_.refresh();
    }

    void open(const std::string& scene) {
        try {
            auto opened =
                std::make_unique<LiveScene>(scene, std::vector<scene::Override>{}, reach_);
            play(*opened);
            take(std::move(opened));
        } catch (const std::exception& error) {
            fail_to_load(error.what());
        }
    }

    void fail_to_load(const std::string& text) {
        notices_.load_error = text;
        log_.add_failure(text);
        window_.refresh();
    }

    void remember() const {
        if (!scene_) return;
        memory_.remember(scene::reload_argument(scene_->session.scene()),
                         {window_.place(), scene_->session.look().camera});
    }

    // Whether the scene's picture is visible: else none is requested.
    bool is_seen() const { return scene_ && !gallery_.is_open() && !window_.hidden(); }

    // ----- what happens between frames

    // Seconds that nothing has to be done for; below 0: until an event comes.
    double sleep() const {
        if (owes_ask_) return 0;
        double least = -1;
        const auto sooner = [&](double seconds) {
            seconds = std::max(0.0, seconds);
            least = least < 0 ? seconds : std::min(least, seconds);
        };
        if (compiling()) sooner(progress_every);
        if (processes_run()) sooner(processes_every);
        if (skipped_) sooner(widgets_due_ - now());
        if (!scene_) return least;
        sooner(next_look_ - now());
        if (!is_seen()) return least;
        if (const auto at = next_change(scene_->session.playback, now())) sooner(*at - now());
        if (const auto at = scheduler_.next_change()) sooner(*at - now());
        return least;
    }

    void attend() {
        if (thread_.lost()) throw gpu::ContextLost();
        take_pictures();
        for (const auto& file : window_.take_dropped()) open(file.string());
        if (processes_run()) {
            if (const auto failure = export_.attend()) log_.add_failure("export: " + *failure);
            topology_.attend();
            if (!gallery_.is_open()) window_.refresh();
        }
        if (gallery_.is_open()) {
            window_.make_current();
            if (gallery_.attend()) window_.refresh();
        }
        if (scene_ && now() >= next_look_) look_at_files();
    }

    void take_pictures() {
        if (auto shown = thread_.take_shown()) {
            scheduler_.learn(*shown, display_, now());
            const std::uint64_t number = shown->number;
            audited_.reset();
            if (auto rays = std::exchange(shown->rays, std::nullopt))
                audits_.audit(std::move(*rays));
            window_.make_current();
            area_.take(std::move(*shown));
            // One that was asked for before says nothing of what failed.
            if (number > failed_number_) notices_.draw_error.clear();
            new_picture_ = true;
        }
        if (const auto given_up = thread_.take_given_up())
            scheduler_.learn(*given_up, display_, now());
        if (const auto audited = audits_.take()) take_audit(*audited);
        if (auto failure = thread_.take_failure()) fail_to_draw(failure->text, failure->number);
    }

    void take_audit(const Audited& audited) {
        if (audited.number != scheduler_.number()) return; // of a picture that is no longer shown
        audited_ = audited;
        log_.add(audited);
        window_.refresh();
    }

    void fail_to_draw(const std::string& text, std::uint64_t number) {
        if (number < failed_number_) return; // of what is asked for no more
        failed_number_ = number;
        window_.refresh();
        if (std::exchange(notices_.draw_error, text) != text) log_.add_failure(text);
    }

    void look_at_files() {
        next_look_ = now() + files_every;
        const LiveScene::News news = scene_->look(now());
        if (!news.any()) return;
        window_.refresh();
        if (news.scene) {
            notices_.load_error.clear();
            window_.set_title(scene_->session.scene().title + " - isomotion");
        }
        if (!news.error.empty()) fail_to_load(news.error);
        if (news.shaders) thread_.forget_shaders();
        if (news.scene || news.shaders) scheduler_.begin_scene();
    }

    void ask() {
        if (!is_seen() || size_.x < 1) return;
        Session& session = scene_->session;
        session.playback = settled(session.playback, now());
        const bool rests = !area_.held() && !touched_;
        try {
            scheduler_.ask(session, frame(), size_, now(), rests);
        } catch (const scene::SceneError& error) {
            fail_to_draw(error.what(), scheduler_.number());
        }
        if (scheduler_.awaits()) audits_.drop();
    }

    std::int64_t frame() const { return frame_at(scene_->session.playback, now()).frame; }

    // ----- commands

    void obey_keys() {
        for (const KeyPress& key : window_.take_keys()) {
            if (ImGui::GetIO().WantTextInput) continue;
            if (const auto command = command_of(key)) obey(*command);
        }
    }

    void obey(Command command) {
        switch (command) {
        case Command::quit:
            return window_.close();
        case Command::full_screen:
            return window_.toggle_full_screen();
        case Command::help:
            notices_.help = !notices_.help;
            return;
        case Command::panel:
            panel_ = !panel_;
            return;
        case Command::rings:
            rings_ = !rings_;
            return;
        case Command::dismiss:
            if (!std::exchange(notices_.help, false) && scene_) gallery_.close();
            return;
        case Command::open:
            if (!gallery_.is_open()) return gallery_.open(memory_.opened());
            if (scene_) gallery_.close();
            return;
        default:
            if (scene_ && !gallery_.is_open()) obey_in_scene(command);
        }
    }

    void obey_in_scene(Command command) {
        Session& session = scene_->session;
        Playback& playback = session.playback;
        Look look = session.look();
        if (const auto view = view_of(command)) {
            look.view = *view;
            return session.set(look);
        }
        switch (command) {
        case Command::toggle:
            playback = toggled(playback, now());
            return;
        case Command::forward:
            playback = stepped(playback, 1, now());
            return;
        case Command::back:
            playback = stepped(playback, -1, now());
            return;
        case Command::first:
            playback = scrubbed(playback, playback.first, now());
            return;
        case Command::last:
            playback = scrubbed(playback, playback.last, now());
            return;
        case Command::faster:
            playback = with_speed(playback, playback.doublings + 1, now());
            return;
        case Command::slower:
            playback = with_speed(playback, playback.doublings - 1, now());
            return;
        case Command::loop:
            playback = with_loop(playback, !playback.loop, now());
            return;
        case Command::reset_camera:
            look.camera.reset();
            return session.set(look);
        case Command::fit_camera:
            return fit_camera();
        case Command::copy_camera:
            return copy_camera();
        case Command::save:
            return export_.save_picture(*scene_, frame(), size_);
        default:
            return;
        }
    }

    // On a software renderer drawing the widgets takes the time of a small picture. So while
    // pictures come, widgets are drawn only now and then: what is dragged is answered by the next
    // picture, and other events soon enough.
    bool widgets_can_wait(bool has_events) {
        const bool is_held = area_.held() || touched_;
        const double due = last_frame_ + (has_events && !is_held
                                              ? std::max(answers_every, widgets_ / part_of_answers)
                                              : std::clamp(widgets_ / part_of_widgets,
                                                           widgets_every, least_widgets));
        // An event that was skipped is answered when it was due, whatever comes after it.
        widgets_due_ = skipped_ ? std::min(widgets_due_, due) : due;
        return scene_ && !gallery_.is_open() && !compiling() && now() < widgets_due_;
    }
    bool overdue() const { return skipped_ && now() >= widgets_due_; }
    bool replace_picture() {
        const auto picture = area_.plain();
        return picture && window_.replace(*picture);
    }

    // The scene as it is shown; none where a value leaves its range, which ask() tells.
    std::optional<scene::SceneAt> scene_now() const {
        try {
            return scene_->session.at(frame());
        } catch (const scene::SceneError&) {
            return std::nullopt;
        }
    }

    void hold_camera(const scene::CameraAt& camera) {
        Look look = scene_->session.look();
        look.camera = camera;
        scene_->session.set(look);
    }

    void fit_camera() {
        if (const auto at = scene_now()) {
            hold_camera(fitted(at->camera, at->surfaces.front().bounds,
                               at->surfaces.front().placement,
                               double(size_.x) / double(std::max(size_.y, 1))));
        }
    }

    void copy_camera() {
        if (const auto at = scene_now()) {
            window_.copy(camera_text(at->camera, scene_->session.scene().camera.shutter));
        }
    }

    // ----- frames

    void show() {
        const bool has_events = window_.stale();
        if (!window_.begin_frame()) {
            skipped_ = false; // nobody sees what is due
            return;
        }
        const ImVec2 area = ImGui::GetIO().DisplaySize;
        if (gallery_.is_open()) {
            show_gallery(area);
        } else if (scene_) {
            const float bar = Transport::height();
            const float side =
                panel_ ? std::min(20.5f * ImGui::GetFontSize(), 0.5f * area.x) : 0.0f;
            show_picture({0, 0}, {area.x - side, area.y - bar});
            if (panel_) show_panel({area.x - side, 0}, {side, area.y - bar});
            show_transport({0, area.y - bar}, {area.x, bar});
        }
        notices_.show(thread_.compiling_since());
        log_.add(take_widget_rects());
        touched_ = ImGui::IsAnyItemActive() && !area_.held();
        skipped_ = widgets_can_wait(has_events);
        if (skipped_ && !new_picture_) {
            skipped_ = scheduler_.awaits();
            if (skipped_) return window_.skip_frame();
        }
        const double begin = now();
        if (!skipped_ || !replace_picture()) {
            skipped_ = false;
            window_.end_frame(scene_ && !gallery_.is_open() ? area_.plain() : std::nullopt);
            last_frame_ = now();
        }
        const double took = now() - begin;
        if (!skipped_) widgets_ += newest * (took - widgets_);
        if (new_picture_) display_ += newest * (took - display_);
        const std::optional<Shown>& shown = area_.shown();
        if (std::exchange(new_picture_, false) && shown) {
            ++pictures_;
            log_.add(*shown, area_.corner(), area_.size(), scheduler_.at_rest());
        }
    }

    void show_gallery(ImVec2 area) {
        begin_pane("gallery", {0, 0}, area, pane);
        const auto chosen = gallery_.show();
        ImGui::End();
        if (chosen) open(*chosen);
    }

    void show_picture(ImVec2 corner, ImVec2 size) {
        ImGui::PushStyleColor(ImGuiCol_WindowBg, ImVec4(0, 0, 0, 0));
        ImGui::PushStyleVar(ImGuiStyleVar_WindowPadding, ImVec2(0, 0));
        begin_pane("picture", corner, size, still_pane);
        ImGui::PopStyleVar();
        ImGui::PopStyleColor();
        ImGui::InvisibleButton("mouse", {std::max(size.x, 1.0f), std::max(size.y, 1.0f)},
                               ImGuiButtonFlags_MouseButtonLeft |
                                   ImGuiButtonFlags_MouseButtonRight |
                                   ImGuiButtonFlags_MouseButtonMiddle);
        const ImVec2 pixel = ImGui::GetIO().DisplayFramebufferScale;
        const scene::Output& output = scene_->session.scene().output;
        const glm::ivec2 room(int(size.x * pixel.x), int(size.y * pixel.y));
        size_ = fitted_size(room, double(output.width) / output.height);
        if (const auto at = scene_now()) {
            if (const auto camera = area_.steer(at->camera)) hold_camera(*camera);
        }
        area_.show(size_, scene_->session.look().map);
        show_rings();
        ImGui::End();
    }

    // Rings mark the events in the picture shown, as its camera saw them. With other parameters
    // there would be other events.
    void show_rings() {
        const std::optional<Shown>& shown = area_.shown();
        if (!rings_ || !shown || !shown->now || !scene_->session.look().overrides.empty()) return;
        const auto found = rings(scene_->events(), *shown->now, double(shown->frame),
                                 double(size_.x) / double(std::max(size_.y, 1)));
        draw_rings(found, scene_->events(), area_.corner(), area_.size());
    }

    void show_panel(ImVec2 corner, ImVec2 size) {
        begin_pane("panel", corner, size, pane);
        Session& session = scene_->session;
        Look look = session.look();
        const std::uint64_t revision = session.revision();
        const std::optional<Command> asked = title_section(session.scene().title);
        std::optional<Command> wish;
        view_section(look, area_.shown());
        if (const auto at = scene_now()) wish = camera_section(look, at->camera);
        // This section comes before those that may be long.
        export_.show(*scene_, frame(), size_);
        parameter_section(look, session, session.scene().timeline.time(frame()));
        method_section(look, session.scene());
        reading_section(area_.shown(), size_, audited_);
        topology_.show(*scene_, rings_);
        ImGui::End();
        if (look != session.look() && revision == session.revision()) session.set(look);
        if (wish) obey_in_scene(*wish);
        if (asked) obey(*asked);
    }

    void show_transport(ImVec2 corner, ImVec2 size) {
        begin_pane("transport", corner, size, still_pane);
        Session& session = scene_->session;
        session.playback =
            transport_.show(session.playback, session.scene().timeline, scene_->markers(), now());
        reading_line(area_.shown(), audited_);
        ImGui::End();
    }

    scene::Reach reach_;
    std::unique_ptr<LiveScene> scene_;
    Memory memory_;
    PictureLog& log_;
    std::shared_ptr<void> guard_; // until there is a context to keep it
    Window window_;
    std::unique_ptr<gpu::Context> drawing_;
    DrawThread thread_;
    AuditThread audits_;
    FrameScheduler scheduler_;
    PictureArea area_;
    std::optional<Audited> audited_; // the picture that is shown
    Transport transport_;
    TopologySection topology_;
    ExportSection export_;
    Gallery gallery_;
    Notices notices_;
    glm::ivec2 size_{0};              // of the picture, in the window
    std::uint64_t failed_number_ = 0; // of the request that draw_error is of
    double next_look_ = now() + files_every;
    bool panel_ = true;
    bool rings_ = true;    // where the topology changes
    bool touched_ = false; // a widget is held: what it changes has not come to rest
    bool new_picture_ = false;
    double last_frame_ = 0;      // when the widgets were drawn last
    double widgets_due_ = 0;     // and are to be again
    double widgets_ = 0;         // how long that takes in the mean, seconds
    double display_ = 0;         // and to put a picture on the screen
    std::uint64_t pictures_ = 0; // put on the screen
    bool owes_ask_ = false;
    bool skipped_ = false; // what came since has not been drawn
};

// Opens the scene with the frames asked for; a scene that has fewer gets more.
std::unique_ptr<LiveScene> opened(const PlayOptions& options) {
    auto scene = std::make_unique<LiveScene>(options.scene, options.overrides, options.reach);
    if (!options.frames) return scene;
    const auto [first, last] = *options.frames;
    if (last > scene->session.scene().timeline.frames) {
        std::vector<scene::Override> overrides = options.overrides;
        overrides.push_back(fmt::format("time.frames={}", last));
        scene = std::make_unique<LiveScene>(options.scene, overrides, options.reach);
    }
    scene->session.playback = with_frames(scene->session.playback, first, last);
    return scene;
}

} // namespace

void play(const PlayOptions& options) {
    // Before the window opens, so that a mistake in the scene is told where it was called from.
    std::unique_ptr<LiveScene> scene;
    if (!options.scene.empty()) {
        scene = opened(options);
        if (options.playing) Player::play(*scene);
    }
    PictureLog log(options.log);
    for (;;) {
        const auto begin = Clock::now();
        Player player(std::move(scene), options, log);
        try {
            return player.run();
        } catch (const gpu::ContextLost& lost) {
            log.add_failure(lost.what());
            if (Clock::now() - begin < lives_at_least) throw NoWindow(lost.what());
            scene = player.take_scene();
        }
    }
}

} // namespace isomotion::player

// Audits rays of the picture at rest in a thread of its own.
#pragma once

#include <condition_variable>
#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

#include "audit/audit.h"
#include "render/renderer.h"
#include "scene/rays.h"
#include "scene/scene_at.h"

namespace isomotion::player {

// The endings of some rays of a picture. Any first part of them is a random sample.
struct RaysToAudit {
    std::uint64_t number = 0; // of the picture's request
    std::shared_ptr<const scene::Scene> scene;
    std::shared_ptr<const scene::SceneAt> now;
    scene::Aim aim;
    std::int64_t frame = 1;
    int width = 0, height = 0;
    std::vector<render::Ending> endings;
};

struct Audited {
    std::uint64_t number = 0; // of the picture's request
    audit::Findings findings;
};

class AuditThread {
public:
    // Calls `wake`, from the thread, when there is something to take.
    explicit AuditThread(std::function<void()> wake);
    ~AuditThread();
    AuditThread(const AuditThread&) = delete;
    AuditThread& operator=(const AuditThread&) = delete;

    // Audits as many of the rays as half a second allows. Replaces rays passed earlier.
    void audit(RaysToAudit rays);
    // Stops the audit, so that the next picture has the machine for itself.
    void drop();
    std::optional<Audited> take();

private:
    void run();
    bool dropped() const;

    std::function<void()> wake_;
    mutable std::mutex mutex_;
    std::condition_variable wanted_;
    std::optional<RaysToAudit> rays_;
    std::optional<Audited> audited_;
    bool dropped_ = false, ending_ = false;
    std::thread thread_; // last: it uses all of the above
};

} // namespace isomotion::player

#include "player/draw/audit_thread.h"

#include <chrono>
#include <utility>

namespace isomotion::player {
namespace {

using Clock = std::chrono::steady_clock;
constexpr auto longest_audit = std::chrono::milliseconds(500);

} // namespace

AuditThread::AuditThread(std::function<void()> wake)
    : wake_(std::move(wake))
    , thread_([this] { run(); }) {}

AuditThread::~AuditThread() {
    {
        const std::lock_guard lock(mutex_);
        ending_ = true;
    }
    wanted_.notify_one();
    thread_.join();
}

void AuditThread::audit(RaysToAudit rays) {
    {
        const std::lock_guard lock(mutex_);
        rays_ = std::move(rays);
        audited_.reset();
    }
    wanted_.notify_one();
}

void AuditThread::drop() {
    const std::lock_guard lock(mutex_);
    dropped_ = true;
    rays_.reset();
    audited_.reset();
}

std::optional<Audited> AuditThread::take() {
    const std::lock_guard lock(mutex_);
    return std::exchange(audited_, std::nullopt);
}

bool AuditThread::dropped() const {
    const std::lock_guard lock(mutex_);
    return dropped_ || rays_ || ending_;
}

void AuditThread::run() {
    std::shared_ptr<const scene::Scene> scene; // that the auditor is for
    std::optional<audit::Auditor> auditor;
    for (;;) {
        std::unique_lock lock(mutex_);
        wanted_.wait(lock, [&] { return ending_ || rays_; });
        if (ending_) return;
        const std::optional<RaysToAudit> taken = std::exchange(rays_, std::nullopt);
        if (!taken) continue;
        const RaysToAudit& rays = *taken;
        dropped_ = false;
        lock.unlock();
        audit::Findings found;
        try {
            if (!auditor || scene != rays.scene) auditor.emplace(*(scene = rays.scene));
            const auto until = Clock::now() + longest_audit;
            const auto stop = [&] { return dropped() || Clock::now() > until; };
            found = auditor->hold(int(rays.frame), *rays.now, rays.aim, rays.width, rays.height,
                                  rays.endings, stop);
        } catch (const std::exception&) { // out of memory: none of the rays was held
            scene.reset();
        }
        lock.lock();
        if (dropped_ || rays_ || ending_) continue;
        audited_ = {rays.number, found};
        lock.unlock();
        wake_();
    }
}

} // namespace isomotion::player

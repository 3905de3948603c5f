#include "api/drawing/parts.h"
#include "api/scene/errors.h"

namespace isomotion {
namespace {

gpu::Backend backend_of(Device::Kind kind) {
    switch (kind) {
    case Device::Kind::automatic:
        break;
    case Device::Kind::egl:
        return gpu::Backend::egl;
    case Device::Kind::osmesa:
        return gpu::Backend::osmesa;
    case Device::Kind::window:
        return gpu::Backend::glfw;
    }
    return gpu::Backend::automatic;
}

} // namespace

Device::Device(Kind kind) {
    parts_ = api::with_errors(
        [&] { return std::make_unique<Parts>(Parts{gpu::Context::create(backend_of(kind))}); });
}

Device::Device(std::unique_ptr<Parts> parts)
    : parts_(std::move(parts)) {}

Device::Device(Device&&) noexcept = default;
Device& Device::operator=(Device&&) noexcept = default;
Device::~Device() = default;

std::string Device::renderer() const { return parts_->context->info().renderer; }
std::string Device::version() const { return parts_->context->info().version; }
std::string Device::backend() const { return parts_->context->info().backend; }

} // namespace isomotion

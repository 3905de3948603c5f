#pragma once

#include <string>
#include <string_view>

#include <isomotion/error.h>

namespace isomotion::gpu {

/// The driver cannot fulfil a request: too large, too many, or out of memory.
class ResourceError : public Error {
public:
    explicit ResourceError(const std::string& message)
        : Error(Code::device, message) {}
};

/// The driver has reset the graphics card, so the context and everything made in it are useless.
/// Only contexts of windows detect this (KHR_robustness).
class ContextLost : public Error {
public:
    ContextLost()
        : Error(Code::device, "the graphics driver was reset") {}
};

/// A shader that does not compile or link. The message holds the driver's log and the source lines
/// around each error.
class CompileError : public Error {
public:
    /// `stage` is "vertex", "fragment", "compute" or "link"; `source` is empty for "link".
    CompileError(std::string_view label, std::string stage, std::string log,
                 std::string_view source);

    const std::string& stage() const noexcept { return stage_; }
    const std::string& log() const noexcept { return log_; }

private:
    std::string stage_, log_;
};

/// Discards earlier GL errors, so that the next check covers only later calls.
void forget_errors();

/// Throws ResourceError that names `what` if a GL call since forget_errors() failed.
void expect_success(std::string_view what);

} // namespace isomotion::gpu

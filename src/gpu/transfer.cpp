#include "gpu/transfer.h"

#include "gpu/error.h"

#include <fmt/format.h>
#include <glad/gl.h>

#include <chrono>
#include <stdexcept>

namespace isomotion::gpu {
namespace {

/// Reads of pixels go to a buffer for as long as it lives.
class Packing {
public:
    explicit Packing(unsigned buffer) { glBindBuffer(GL_PIXEL_PACK_BUFFER, buffer); }
    ~Packing() { glBindBuffer(GL_PIXEL_PACK_BUFFER, 0); }
    Packing(const Packing&) = delete;
    Packing& operator=(const Packing&) = delete;
};

} // namespace

struct Transfer::Fence {
    GLsync sync = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);

    Fence() = default;
    ~Fence() { glDeleteSync(sync); }
    Fence(const Fence&) = delete;
    Fence& operator=(const Fence&) = delete;

    void wait() const {
        constexpr GLuint64 second = 1'000'000'000;
        for (;;) {
            const GLenum state = glClientWaitSync(sync, GL_SYNC_FLUSH_COMMANDS_BIT, second);
            if (state == GL_WAIT_FAILED) throw ResourceError("the driver lost a read of pixels");
            if (state != GL_TIMEOUT_EXPIRED) return;
        }
    }
};

Transfer::Transfer(std::size_t bytes)
    : capacity_(bytes) {
    forget_errors();
    const Packing packing(name_.get());
    glBufferData(GL_PIXEL_PACK_BUFFER, GLsizeiptr(bytes), nullptr, GL_STREAM_READ);
    expect_success(fmt::format("a buffer of {} bytes for pixels", bytes));
}

Transfer::~Transfer() = default;
Transfer::Transfer(Transfer&&) noexcept = default;
Transfer& Transfer::operator=(Transfer&&) noexcept = default;

std::size_t Transfer::ask(const Target& from, int attachment, Rectangle area,
                          std::size_t offset) const {
    const std::size_t end = offset + from.bytes_in(attachment, area);
    if (end > capacity_) {
        throw std::length_error(
            fmt::format("pixels up to byte {} for a buffer of {}", end, capacity_));
    }
    const Packing packing(name_.get());
    from.pack(attachment, area, offset);
    return end;
}

void Transfer::send() {
    sent_ = std::make_unique<Fence>();
    glFlush();
}

void Transfer::read(const std::function<void(std::span<const std::byte>)>& use) {
    if (!sent_) throw std::logic_error("no pixels were sent");
    sent_->wait();
    sent_.reset();
    const Packing packing(name_.get());
    const void* bytes =
        glMapBufferRange(GL_PIXEL_PACK_BUFFER, 0, GLsizeiptr(capacity_), GL_MAP_READ_BIT);
    if (!bytes) throw ResourceError("the driver shows no pixels that it was asked for");
    const struct Mapped {
        ~Mapped() { glUnmapBuffer(GL_PIXEL_PACK_BUFFER); }
    } mapped;
    use({static_cast<const std::byte*>(bytes), capacity_});
}

} // namespace isomotion::gpu

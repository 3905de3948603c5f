// An array's elements on the GPU, in the storage that the assembly chose.
#pragma once

#include <optional>
#include <span>

#include "gpu/buffer.h"
#include "render/pass_table.h"
#include "shader/field_text.h"

namespace isomotion::render {

class ArrayBuffer {
public:
    // `lists`: additional space, in elements, for lists of those that matter in beams.
    ArrayBuffer(const shader::ArrayStorage& storage, int lists)
        : name_(storage.name) {
        const std::size_t texels =
            std::size_t(storage.capacity + lists) * std::size_t(storage.texels);
        if (storage.kind == shader::ArrayStorage::Kind::uniform_block) {
            block_.emplace(texels * sizeof(glm::vec4));
        } else {
            buffer_.emplace(texels);
        }
    }
    void update(std::span<const glm::vec4> texels) {
        if (texels.empty()) return;
        if (block_) block_->update(std::as_bytes(texels));
        if (buffer_) buffer_->update(texels);
    }
    void bind(PassTable& table) const {
        if (block_) table.bind(name_ + "_block", *block_);
        if (buffer_) table.bind(name_, *buffer_);
    }
    // Binds it as buffer 0, which shaders write; waits for these writes before others read it.
    void bind_for_lists() const {
        if (buffer_) buffer_->bind_storage(0);
    }
    void wait_for_lists() const {
        if (buffer_) buffer_->wait_for_storage();
    }

private:
    std::string name_;
    std::optional<gpu::UniformBuffer> block_;
    std::optional<gpu::TextureBuffer> buffer_;
};

} // namespace isomotion::render

// The values of the formula's names on the GPU: parameters and the elements of arrays.
#pragma once

#include <vector>

#include "render/array_buffer.h"
#include "render/frame_inputs.h"
#include "render/pass_table.h"

namespace isomotion::render {

class FieldBuffers {
public:
    // `listed`: places for elements of lists behind each array that has lists.
    FieldBuffers(const synthesis::FieldStorage& storage, int listed)
        : parameters_(std::size_t(storage.parameter_vectors + storage.count_vectors) * 16)
        , has_lists_(synthesis::has_lists(storage)) {
        for (const auto& array : storage.arrays) {
            arrays_.emplace_back(array, array.has_lists ? listed : 0);
        }
    }

    void upload(PassTable& table, const FieldInputs& inputs) {
        parameters_.update(inputs.parameters);
        table.bind("Parameters", parameters_);
        for (std::size_t a = 0; a < arrays_.size(); ++a) {
            arrays_[a].update(inputs.arrays[a]);
            arrays_[a].bind(table);
        }
    }

    // The array whose elements beams make lists of, or null.
    const ArrayBuffer* listed() const { return has_lists_ ? &arrays_[0] : nullptr; }

private:
    gpu::UniformBuffer parameters_;
    std::vector<ArrayBuffer> arrays_;
    bool has_lists_;
};

} // namespace isomotion::render

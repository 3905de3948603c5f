// The values of the formula's names on the GPU: parameters and the elements of arrays.
#pragma once

#include <optional>
#include <vector>

#include "render/array_buffer.h"
#include "render/frame_inputs.h"
#include "render/pass_table.h"

namespace isomotion::render {

// The grid of elements that matter in each cell (elements/element_grid.h).
struct GridBuffers {
    gpu::IntegerBuffer cells{gpu::IntegerBuffer::Texel::two};
    gpu::IntegerBuffer listed{gpu::IntegerBuffer::Texel::one};

    void update(const elements::ElementGrid& grid) {
        static_assert(sizeof(elements::Cell) == 2 * sizeof(std::uint32_t));
        cells.update({&grid.cells.front().packed, 2 * grid.cells.size()});
        listed.update(grid.listed);
    }
    void bind(PassTable& table) const {
        table.bind("cells_texture", cells);
        table.bind("listed_texture", listed);
    }
};

// Tapes and where they lie (formula/tape/tape_cells.h).
struct TapeBuffers {
    gpu::IntegerBuffer words{gpu::IntegerBuffer::Texel::two};
    gpu::IntegerBuffer spans{gpu::IntegerBuffer::Texel::two};

    void update(const formula::TapeCells& tapes) {
        words.update(tapes.words);
        spans.update(tapes.spans);
    }
    void bind(PassTable& table) const {
        table.bind("tape_words", words);
        table.bind("tape_spans", spans);
    }
};

class FieldBuffers {
public:
    // `listed`: space, in elements, for the lists behind each array that has lists.
    FieldBuffers(const shader::FieldStorage& storage, int listed)
        : parameters_(std::size_t(storage.vectors()) * 16)
        , has_lists_(shader::has_lists(storage)) {
        for (const auto& array : storage.arrays) {
            arrays_.emplace_back(array, array.has_lists ? listed : 0);
        }
    }

    void upload(PassTable& table, const FieldInputs& inputs) {
        parameters_.update(inputs.parameters);
        if (inputs.grid) {
            if (!grid_) grid_.emplace();
            grid_->update(*inputs.grid);
        }
        if (inputs.tapes) {
            if (!tapes_) tapes_.emplace();
            tapes_->update(*inputs.tapes);
        }
        for (std::size_t a = 0; a < arrays_.size(); ++a) arrays_[a].update(inputs.arrays[a]);
        bind(table);
    }

    // Binds what was uploaded last.
    void bind(PassTable& table) const {
        if (grid_) grid_->bind(table);
        if (tapes_) tapes_->bind(table);
        table.bind("Parameters", parameters_);
        for (const ArrayBuffer& array : arrays_) array.bind(table);
    }

    // The array for whose elements beams make lists, or null.
    const ArrayBuffer* listed() const { return has_lists_ ? &arrays_[0] : nullptr; }

private:
    gpu::UniformBuffer parameters_;
    std::optional<GridBuffers> grid_;
    std::optional<TapeBuffers> tapes_;
    std::vector<ArrayBuffer> arrays_;
    bool has_lists_;
};

} // namespace isomotion::render

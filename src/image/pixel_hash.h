#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "base/content_hash.h"

namespace isomotion::image {

/// A hash of a picture's content, independent of how a file stores it: equal for files that another
/// encoder version compressed differently, or that have other metadata.
///
/// It covers the samples as the file holds them: the codes of a PNG, the halves and floats of an
/// EXR as floats, with all NaNs equal. Rows are added from the top, in bands of any height;
/// channels in any order.
class PixelHash {
public:
    PixelHash(int width, int height);

    /// Codes of a PNG, with all channels of a pixel together.
    template<class Code> void add_codes(std::span<const Code> interleaved) {
        channels_["codes " + std::to_string(8 * sizeof(Code))].add_values(interleaved);
    }
    /// Every `stride`-th sample from `first` on: one channel of interleaved samples.
    void add_channel(const std::string& name, std::span<const float> interleaved, std::size_t first,
                     std::size_t stride);

    std::string text() const;

private:
    std::int32_t size_[2];
    std::map<std::string, base::ContentHash> channels_;
};

} // namespace isomotion::image

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>

#include "base/content_hash.h"

namespace isomotion::image {

/// A hash of what a picture shows, whatever bytes a file keeps it in: equal for files that another
/// version of an encoder compressed otherwise, or that hold other metadata.
///
/// It is taken of the samples as the file holds them: the codes of a PNG, the halves and floats of
/// an EXR as floats, a NaN as any other NaN. Rows are added from the top, in bands of any height;
/// channels in any order.
class PixelHash {
public:
    PixelHash(int width, int height);

    /// Codes of a PNG, all channels of a pixel together.
    template<class Code> void add_codes(std::span<const Code> interleaved) {
        channels_["codes " + std::to_string(8 * sizeof(Code))].add_values(interleaved);
    }
    /// Every `stride`-th sample from `first` on: one channel of interleaved ones.
    void add_channel(const std::string& name, std::span<const float> interleaved, std::size_t first,
                     std::size_t stride);

    std::string text() const;

private:
    std::int32_t size_[2];
    std::map<std::string, base::ContentHash> channels_;
};

} // namespace isomotion::image

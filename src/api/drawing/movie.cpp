#include <algorithm>

#include <fmt/format.h>

#include "api/drawing/parts.h"
#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "sequence/movies/movie.h"

namespace isomotion {
bool write_movie(const std::filesystem::path& file, const Scene& scene, int count,
                 const std::function<Picture(int)>& picture, const Watcher& watcher) {
    return api::with_errors([&] {
        if (!picture) throw Error(Error::Code::input, "a movie needs pictures");
        const sequence::MoviePictures pictures{
            std::size_t(std::max(count, 0)),
            [&](std::size_t k) {
                if (watcher.progress) watcher.progress("movie", double(k) / count);
                return api::frame_of(picture(int(k)));
            },
            [](std::size_t k) { return fmt::format("picture {}", k + 1); },
        };
        const animation::FrameRate rate = scene.parts().scene.timeline.fps;
        return sequence::write_movie(file, pictures, {rate.numerator, rate.denominator},
                                     watcher.stop);
    });
}

} // namespace isomotion

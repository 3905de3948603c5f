#include "page/page.h"

#include "api/scene/errors.h"
#include "api/scene/parts.h"

namespace isomotion {

std::string page_of(const Scene& scene, const Watcher& watcher) {
    return api::with_errors([&] {
        page::PageOptions options;
        options.warn = watcher.warn;
        return page::page(scene.parts().scene, options);
    });
}

} // namespace isomotion

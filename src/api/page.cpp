#include "page/page.h"

#include "api/errors.h"
#include "api/scene/parts.h"

namespace isomotion {

std::string page_of(const Scene& scene, const PageSettings& settings, const Watcher& watcher) {
    return api::with_all_errors([&] {
        page::PageOptions options;
        options.report = settings.report;
        options.movie = settings.movie;
        options.warn = watcher.warn;
        return page::page(scene.parts().scene, options);
    });
}

} // namespace isomotion

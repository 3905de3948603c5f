#include "page/page.h"

#include "api/scene/errors.h"
#include "api/scene/parts.h"

namespace isomotion {

std::string page_of(const Scene& scene, const PageSettings& settings,
                    const std::function<void(const std::string&)>& warn) {
    return api::with_errors([&] {
        page::PageOptions options;
        options.report = settings.report;
        options.movie = settings.movie;
        options.warn = warn;
        return page::page(scene.parts().scene, options);
    });
}

} // namespace isomotion

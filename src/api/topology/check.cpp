#include "api/scene/errors.h"
#include "api/scene/parts.h"
#include "api/topology/parts.h"
#include "topology/timeline/expectation.h"

namespace isomotion {

struct Expectation::Parts {
    std::filesystem::path file;
    topology::Expectation expectation;
};

namespace {

TopologyCheck::Outcome outcome_of(topology::Outcome outcome) {
    switch (outcome) {
    case topology::Outcome::passes:
        return TopologyCheck::Outcome::passes;
    case topology::Outcome::differs:
        return TopologyCheck::Outcome::differs;
    case topology::Outcome::incomplete:
        break;
    }
    return TopologyCheck::Outcome::incomplete;
}

} // namespace

Expectation::Expectation(const std::filesystem::path& file, const Scene& scene) {
    parts_ = api::with_errors([&] {
        const animation::FrameRate fps = scene.parts().scene.timeline.fps;
        return std::make_shared<const Parts>(Parts{file, topology::read_expectation(file, fps)});
    });
}

TopologyCheck Expectation::check(const Topology& found, double dt) const {
    return api::with_errors([&] {
        topology::Check judged = topology::check(parts_->expectation, found.parts().record, dt);
        return TopologyCheck{.outcome = outcome_of(judged.outcome()),
                             .differences = judged.differences,
                             .undecided = judged.undecided,
                             .agreed = judged.agreed,
                             .summary = topology::text(judged, parts_->file.string())};
    });
}

} // namespace isomotion

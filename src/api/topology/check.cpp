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

TopologyCheck check(const Topology& found, const Expectation& expected, double dt) {
    return api::with_errors([&] {
        topology::Check judged =
            topology::check(expected.parts().expectation, found.parts().record, dt);
        return TopologyCheck{.outcome = outcome_of(judged.outcome()),
                             .differences = judged.differences,
                             .undecided = judged.undecided,
                             .agreed = judged.agreed,
                             .summary = topology::text(judged, expected.parts().file.string())};
    });
}

} // namespace isomotion

// Proves events again in another arithmetic: balls (Arb; Johansson 2017).
//
// The second proof shares only the formula and its derivatives with the first. Functions are
// enclosed by Arb instead of the C library, roundings have 128 bits and more, and the unknowns are
// the place and the time, whatever clock the search used. So a mistake in intervals, or in the
// times at which a track has a value, does not pass both proofs.
#pragma once

#include <functional>
#include <vector>

#include "scene/scene.h"
#include "topology/field/motion.h"
#include "topology/field/moving_field.h"
#include "topology/field/sphere_chart.h"
#include "topology/timeline/event.h"

namespace isomotion::ball {
class Ball;
}

namespace isomotion::topology {

class ArbVerifier {
public:
    // Verifies the scene's events in `range`.
    ArbVerifier(const scene::OneSurface& one, Side side, formula::Interval range);
    // Motions by time.
    explicit ArbVerifier(Motions all);

    // `holds`: the event's enclosure of place and time holds exactly one point where the surface is
    // singular along the stratum, F has the event's index there, and F falls in time if the event
    // grows. `fails` refutes this.
    enum class Answer { holds, open, fails };
    // May be called from any thread.
    Answer verify(const Event& event) const;

private:
    // One piece of the motion in one stratum. Its coordinates are x, y, z or those of a chart.
    struct System {
        Stratum stratum;
        formula::Interval clock;
        std::vector<std::size_t> unknowns; // indices among the coordinates and the time
        formula::Program place;            // x, y, z as functions of the coordinates
        formula::Program coordinates;      // the unknown coordinates as functions of x, y, z: valid
                                           // where `ahead` is above 0
        formula::Program ahead;
        formula::Program jet; // derivatives by the unknowns
        const formula::Bindings<double>* bindings;
    };
    static System system(const Motion& motion, const Stratum& stratum);
    static System on_chart(const Motion& motion, const SphereChart& chart);
    static std::vector<ball::Ball> unknowns(const System& system, const Event& event,
                                            long precision);
    static Answer verify(const System& system, const Event& event, long precision);
    static bool may_hold(const System& system, const Event& event);
    static Answer in_box(const System& system, const Event& event,
                         std::span<const ball::Ball> unknowns, long precision);

    Motions motions_;
    std::vector<System> systems_;
};

struct VerifyOptions {
    int threads = 1;                 // the result doesn't depend on it
    std::function<bool()> stopped{}; // from any thread
};

// Verifies all proved events and sets Event::is_proved_again for those that hold. Events that it
// refutes lose `is_proved`, and a doubt says so.
void prove_again(Timeline& timeline, const ArbVerifier& proof, const VerifyOptions& how = {});

} // namespace isomotion::topology

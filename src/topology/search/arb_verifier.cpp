#include "topology/search/arb_verifier.h"

#include <algorithm>

#include <fmt/format.h>

#include "arb/ball_program.h"
#include "base/workers.h"
#include "formula/graph/substitute.h"
#include "topology/search/critical_system.h"

namespace isomotion::topology {
namespace {

using ball::Ball;
using formula::Interval;
using formula::NodeId;
using Balls = std::vector<Ball>;

// Bits, doubled as long as the answer is open: an enclosure may be as narrow as doubles are.
constexpr long first_precision = 128, last_precision = 2048;
// Each gains about the bits of a double.
constexpr int most_contractions = 40;

// Numbers a row, of a matrix of balls.
struct Rows {
    std::size_t n;
    Balls entries = Balls(n * n);
    Ball& at(std::size_t i, std::size_t j) { return entries[i * n + j]; }
    const Ball& at(std::size_t i, std::size_t j) const { return entries[i * n + j]; }
};

// F = 0 and its slopes along the free axes, and the derivatives of these by the unknowns.
struct Values {
    Balls residual;
    Rows jacobian;
};

// The bits of a ball's middle that a double has.
double middle_of(const Ball& ball) { return arf_get_d(arb_midref(ball.get()), ARF_RND_NEAR); }

Balls middles_of(const Balls& balls) {
    Balls middles(balls.size());
    for (std::size_t k = 0; k < balls.size(); ++k)
        arb_get_mid_arb(middles[k].get(), balls[k].get());
    return middles;
}

Values values(const formula::Program& jet, const formula::Bindings<double>& bindings,
              std::span<const std::size_t> unknowns, std::span<const Ball> at, long precision) {
    const std::size_t n = unknowns.size();
    std::array<Ball, 4> inputs;
    for (std::size_t k = 0; k < n; ++k) inputs[unknowns[k]] = at[k];
    Balls outputs(jet.outputs.size());
    ball::BallProgram(jet).evaluate(bindings, inputs, outputs, precision);
    Jet<Ball> f;
    unpack(f, n, n - 1, [&](std::size_t k) { return outputs[k]; });
    Values all{Balls(n), Rows{n}};
    const auto residual_at = residual(f, n);
    const auto rows = topology::jacobian(f, n);
    for (std::size_t i = 0; i < n; ++i) {
        all.residual[i] = residual_at[i];
        for (std::size_t k = 0; k < n; ++k) all.jacobian.at(i, k) = rows[i][k];
    }
    return all;
}

// m - Y f(m) + (I - Y S)(X - m): Krawczyk's operator.
Balls image(const Balls& box, const Balls& middle, const Balls& at_middle, const Rows& slopes,
            const Matrix& y, long precision) {
    const std::size_t n = box.size();
    Balls image = middle;
    for (std::size_t i = 0; i < n; ++i) {
        for (std::size_t l = 0; l < n; ++l) {
            const Ball factor(-y[i][l]);
            arb_addmul(image[i].get(), factor.get(), at_middle[l].get(), precision);
        }
        for (std::size_t j = 0; j < n; ++j) {
            Ball entry(i == j ? 1.0 : 0.0), reach;
            for (std::size_t l = 0; l < n; ++l) {
                const Ball factor(-y[i][l]);
                arb_addmul(entry.get(), factor.get(), slopes.at(l, j).get(), precision);
            }
            arb_sub(reach.get(), box[j].get(), middle[j].get(), precision);
            arb_addmul(image[i].get(), entry.get(), reach.get(), precision);
        }
    }
    return image;
}

std::optional<Matrix> middle_inverse(const Rows& slopes) {
    Matrix middle{};
    for (std::size_t i = 0; i < slopes.n; ++i) {
        for (std::size_t j = 0; j < slopes.n; ++j) {
            if (!slopes.at(i, j).is_finite()) return std::nullopt;
            middle[i][j] = middle_of(slopes.at(i, j));
        }
    }
    return inverse(middle, int(slopes.n));
}

bool is_inside(const Balls& inner, const Balls& outer) {
    for (std::size_t k = 0; k < inner.size(); ++k) {
        if (!arb_contains_interior(outer[k].get(), inner[k].get())) return false;
    }
    return true;
}

bool are_apart(const Balls& a, const Balls& b) {
    for (std::size_t k = 0; k < a.size(); ++k) {
        if (!arb_overlaps(a[k].get(), b[k].get())) return true;
    }
    return false;
}

// Sign, or 0, of the sum of all principal minors of `order` rows among the `d` rows below the
// first of a system's derivatives: of the Hessian's.
int sign_of_minors(const Rows& jacobian, std::size_t order, long precision) {
    const std::size_t d = jacobian.n - 1;
    const auto h = [&](std::size_t i, std::size_t j) { return jacobian.at(1 + i, j).get(); };
    Ball sum, product;
    const auto add_pair = [&](Ball& to, std::size_t i, std::size_t j, std::size_t k,
                              std::size_t l) { // h_ik h_jl - h_il h_jk
        arb_mul(product.get(), h(i, k), h(j, l), precision);
        arb_add(to.get(), to.get(), product.get(), precision);
        arb_mul(product.get(), h(i, l), h(j, k), precision);
        arb_sub(to.get(), to.get(), product.get(), precision);
    };
    if (order == 1) {
        for (std::size_t i = 0; i < d; ++i) arb_add(sum.get(), sum.get(), h(i, i), precision);
    } else if (order == 2) {
        for (std::size_t i = 0; i < d; ++i) {
            for (std::size_t j = i + 1; j < d; ++j) add_pair(sum, i, j, i, j);
        }
    } else {
        for (std::size_t k = 0; k < 3; ++k) {
            Ball minor;
            add_pair(minor, 1, 2, (k + 1) % 3, (k + 2) % 3);
            arb_addmul(sum.get(), h(0, k), minor.get(), precision);
        }
    }
    return sum.sign();
}

// How many eigenvalues of the Hessian are negative; -1 if that is open. They are real, so by
// Descartes' rule the signs of the characteristic polynomial's coefficients e_1, ..., e_d (sums of
// principal minors) tell: all are positive for index 0, and alternate from a negative one for index
// d; what is between follows from the sign of the last, the determinant.
int index_of(const Rows& jacobian, long precision) {
    const std::size_t d = jacobian.n - 1;
    if (d == 0) return 0;
    std::array<int, 4> sign{};
    for (std::size_t k = 1; k <= d; ++k) sign[k] = sign_of_minors(jacobian, k, precision);
    if (sign[d] == 0) return -1;
    const auto all_are = [&](auto wanted) {
        bool all = true;
        for (std::size_t k = 1; k <= d; ++k) all = all && sign[k] == wanted(k);
        return all;
    };
    const auto one_is_not = [&](auto wanted) {
        bool one = false;
        for (std::size_t k = 1; k <= d; ++k) one = one || sign[k] == -wanted(k);
        return one;
    };
    const auto positive = [](std::size_t) { return 1; };
    const auto alternating = [](std::size_t k) { return k % 2 == 0 ? 1 : -1; };
    if (all_are(positive)) return 0;
    if (all_are(alternating)) return int(d);
    if (!one_is_not(positive) || !one_is_not(alternating)) return -1;
    // Neither 0 nor d: of 1 and 2 the determinant's sign takes one.
    return sign[d] < 0 ? 1 : 2;
}

} // namespace

ArbVerifier::ArbVerifier(const scene::OneSurface& one, Side side, Interval range)
    : ArbVerifier(motions(one, side, range, Clock::time)) {}

ArbVerifier::ArbVerifier(Motions all)
    : motions_(std::move(all)) {
    for (const Motion& motion : motions_.pieces) {
        if (!motion.moves) continue;
        if (motion.shape == scene::Bounds::Shape::box) {
            for (const Stratum& stratum : strata_of_box())
                systems_.push_back(system(motion, stratum));
            continue;
        }
        systems_.push_back(system(motion, Stratum{}));
        for (const SphereChart& chart : SphereChart::all())
            systems_.push_back(on_chart(motion, chart));
    }
}

ArbVerifier::System ArbVerifier::system(const Motion& motion, const Stratum& stratum) {
    System made;
    made.stratum = stratum;
    made.clock = motion.clock;
    made.bindings = &motion.bindings;
    formula::Graph g = motion.graph;
    std::array<NodeId, 3> stands_for{};
    std::vector<NodeId> free;
    for (std::size_t k = 0; k < 3; ++k) {
        const Stratum::End end = stratum.axes[k];
        if (end == Stratum::End::free) {
            made.unknowns.push_back(k);
            free.push_back(g.input(int(k)));
        }
        stands_for[k] = end == Stratum::End::free  ? g.input(int(k))
                        : end == Stratum::End::low ? motion.low[k]
                                                   : motion.high[k];
    }
    made.unknowns.push_back(clock_input);
    made.place = formula::schedule(g, stands_for);
    made.coordinates = formula::schedule(g, free);
    made.ahead = formula::schedule(g, std::array{g.constant(1)});
    const NodeId field =
        formula::substitute(g, g, std::array{motion.field},
                            [&](formula::Graph&, const formula::Node& node, NodeId rebuilt) {
                                const bool is_axis =
                                    node.op == formula::Op::input && node.index < clock_input;
                                return is_axis ? stands_for[std::size_t(node.index)] : rebuilt;
                            })[0];
    made.jet =
        formula::schedule(g, jet_over_boxes(g, field, made.unknowns, made.unknowns.size() - 1));
    return made;
}

ArbVerifier::System ArbVerifier::on_chart(const Motion& motion, const SphereChart& chart) {
    System made = system(chart.motion(motion), SphereChart::wall());
    made.bindings = &motion.bindings;
    formula::Graph g = motion.graph;
    made.place = formula::schedule(g, chart.place(g, motion, g.constant(1)));
    const SphereChart::Seen seen = chart.seen(g, motion);
    made.coordinates = formula::schedule(g, seen.coordinates);
    made.ahead = formula::schedule(g, std::array{seen.ahead});
    return made;
}

// The unknowns of all points in the event's box of place and time.
Balls ArbVerifier::unknowns(const System& system, const Event& event, long precision) {
    std::array<Ball, 4> inputs;
    for (std::size_t k = 0; k < 3; ++k) inputs[k] = Ball(event.where[k].lo, event.where[k].hi);
    inputs[clock_input] = Ball(event.time.lo, event.time.hi);
    Balls found(system.unknowns.size() - 1);
    ball::BallProgram(system.coordinates).evaluate(*system.bindings, inputs, found, precision);
    found.push_back(inputs[clock_input]);
    return found;
}

// Compares what the unknowns stand for with the event's box of place and time.
ArbVerifier::Answer ArbVerifier::in_box(const System& system, const Event& event,
                                        std::span<const Ball> unknowns, long precision) {
    std::array<Ball, 4> inputs;
    for (std::size_t k = 0; k < unknowns.size(); ++k) inputs[system.unknowns[k]] = unknowns[k];
    Balls at(3);
    ball::BallProgram(system.place).evaluate(*system.bindings, inputs, at, precision);
    at.push_back(unknowns.back());
    Answer answer = Answer::holds;
    for (std::size_t k = 0; k < 4; ++k) {
        const Interval side = k < 3 ? event.where[k] : event.time;
        if (at[k].is_apart_from(side.lo, side.hi)) return Answer::fails;
        if (!at[k].is_in(side.lo, side.hi)) answer = Answer::open;
    }
    return answer;
}

bool ArbVerifier::may_hold(const System& system, const Event& event) {
    if (system.stratum.dimension() != event.stratum || !contains(system.clock, event.time))
        return false;
    std::array<Ball, 4> inputs;
    for (std::size_t k = 0; k < 3; ++k) inputs[k] = Ball(event.where[k].lo, event.where[k].hi);
    inputs[clock_input] = Ball(event.time.lo, event.time.hi);
    Balls ahead(1);
    ball::BallProgram(system.ahead).evaluate(*system.bindings, inputs, ahead, first_precision);
    return ahead[0].sign() > 0 && in_box(system, event, unknowns(system, event, first_precision),
                                         first_precision) != Answer::fails;
}

ArbVerifier::Answer ArbVerifier::verify(const System& system, const Event& event, long precision) {
    const std::size_t n = system.unknowns.size();
    // The event's box, wider: its root may be next to its walls.
    Balls wide = unknowns(system, event, precision);
    for (Ball& ball : wide) {
        if (!ball.is_finite()) return Answer::open;
        Ball margin, least(std::max(1.0, std::abs(middle_of(ball))));
        arb_get_rad_arb(margin.get(), ball.get());
        arb_mul_si(margin.get(), margin.get(), 6, precision);
        arb_mul_2exp_si(least.get(), least.get(), -precision / 2);
        arb_add(margin.get(), margin.get(), least.get(), precision);
        arb_add_error(ball.get(), margin.get());
    }
    const auto at = [&](const Balls& where) {
        return values(system.jet, *system.bindings, system.unknowns, where, precision);
    };
    const Rows slopes = at(wide).jacobian;
    const auto y = middle_inverse(slopes);
    if (!y) return Answer::open;
    const auto krawczyk = [&](const Balls& box) {
        const Balls m = middles_of(box);
        return image(box, m, at(m).residual, slopes, *y, precision);
    };
    Balls root = krawczyk(wide);
    if (are_apart(root, wide)) return Answer::fails;
    if (!is_inside(root, wide)) return Answer::open;
    // Now `wide` holds one root, which is closed in on until it is in the event's box or apart.
    const auto place = [&] { return in_box(system, event, root, precision); };
    Answer is_inside_box = place();
    for (int k = 0; k < most_contractions && is_inside_box == Answer::open; ++k) {
        const Balls next = krawczyk(root);
        bool shrinks = false;
        for (std::size_t i = 0; i < n; ++i) {
            if (mag_cmp(arb_radref(next[i].get()), arb_radref(root[i].get())) >= 0) continue;
            root[i] = next[i];
            shrinks = true;
        }
        if (!shrinks) break;
        is_inside_box = place();
    }
    if (is_inside_box != Answer::holds) return is_inside_box;
    const Values there = at(root);
    const int by_time = there.jacobian.at(0, n - 1).sign();
    const int index = index_of(there.jacobian, precision);
    if (by_time == 0 || index < 0) return Answer::open;
    return index == event.index && (by_time < 0) == event.grows ? Answer::holds : Answer::fails;
}

ArbVerifier::Answer ArbVerifier::verify(const Event& event) const {
    bool is_somewhere = false, fails_everywhere = true;
    for (const System& system : systems_) {
        if (!may_hold(system, event)) continue;
        is_somewhere = true;
        Answer answer = Answer::open;
        for (long bits = first_precision; bits <= last_precision && answer == Answer::open;
             bits *= 2) {
            answer = verify(system, event, bits);
        }
        if (answer == Answer::holds) return answer;
        fails_everywhere = fails_everywhere && answer == Answer::fails;
    }
    return is_somewhere && fails_everywhere ? Answer::fails : Answer::open;
}

void prove_again(Timeline& timeline, const ArbVerifier& proof, const VerifyOptions& how) {
    std::vector<ArbVerifier::Answer> answers(timeline.events.size(), ArbVerifier::Answer::open);
    struct Caches { // of a thread
        ~Caches() { flint_cleanup(); }
    };
    const auto verify_one = [&] {
        return [&, caches = Caches{}](std::size_t k) {
            if (timeline.events[k].is_proved) answers[k] = proof.verify(timeline.events[k]);
        };
    };
    base::share({.count = answers.size(), .threads = how.threads, .stopped = how.stopped},
                verify_one);
    for (std::size_t k = 0; k < answers.size(); ++k) {
        Event& event = timeline.events[k];
        event.is_proved_again = answers[k] == ArbVerifier::Answer::holds;
        if (answers[k] != ArbVerifier::Answer::fails) continue;
        event.is_proved = false;
        timeline.is_proved = false;
        timeline.doubts.push_back(
            fmt::format("the event at {} s is not what it was proved to be, by ball arithmetic",
                        mid(event.time)));
    }
}

} // namespace isomotion::topology

#include "formula/enclosure.h"

#include "formula/graph/chebyshev_form.h"
#include "formula/graph/continuity.h"
#include "formula/graph/decoration.h"
#include "formula/graph/degree.h"
#include "formula/graph/derivative.h"
#include "formula/graph/in_range.h"
#include "formula/graph/numerator.h"
#include "formula/graph/roughness.h"
#include "formula/kept_enclosures.h"

namespace isomotion::formula {

namespace {

std::vector<NodeId> direction(Graph& g) {
    return {g.input(first_direction), g.input(first_direction + 1), g.input(first_direction + 2)};
}

bool has_chebyshev(const Graph& g) {
    for (std::size_t id = 0; id < g.size(); ++id) {
        if (g[NodeId(id)].op == Op::chebyshev) return true;
    }
    return false;
}

// What truth asks of a field over a box, as expressions.
struct Enclosed {
    explicit Enclosed(const Field& field)
        : graph(field.graph) {
        graph.fold_exactly();
        const NodeId root = with_chebyshev(graph, field.root);
        const NodeId without = gaps(graph, root);
        value = graph.add(bounds_in_range(graph, root), without);
        const InRange in_range(graph, root, Purpose::slopes);
        const auto slope = [&](const std::vector<NodeId>& directions) {
            const NodeId found =
                differentiate_inputs(graph, in_range.root(), directions, Slopes::generalized);
            return graph.add(in_range.complete(std::array{found}).front(), without);
        };
        const NodeId one = graph.constant(1), zero = graph.constant(0);
        along = slope(direction(graph));
        gradient = {slope({one, zero, zero}), slope({zero, one, zero}), slope({zero, zero, one})};
        // F is searched for jumps as it is written: what stands for it may be cut off elsewhere.
        const NodeId jumping = jumps(graph, field.root);
        jump = jumping;
        // Where jumps count as walls, 1/(floor(x) - 0.5) has one.
        none = within_gaps(graph, root);
        if (field.wall_distance == 0) none = graph.add(none, without_zero(graph, root));
        is_root = field.wall_distance > 0 ? unless_bounded(graph, value) : jumping;
    }

    bool may_lack_values() const { return !graph.is_constant(none, 0); }

    Graph graph;
    NodeId value = 0, along = 0, jump = 0, none = 0, is_root = 0;
    std::array<NodeId, 3> gradient{};
};

EnclosurePrograms derive_programs(const Field& field) {
    Enclosed e(field);
    Graph& g = e.graph;
    // Walls stand where values jump and are bounded, as those of tanh(x/0) are.
    const NodeId by_0 =
        field.wall_distance > 0 ? g.constant(0) : divided_by_0(g, with_chebyshev(g, field.root));
    const NodeId nothing = g.add(e.none, by_0);
    return {schedule(g, std::array{e.value}), schedule(g, std::array{e.value, e.along}),
            schedule(g, e.gradient), schedule(g, std::array{e.is_root, e.none}),
            schedule(g, std::array{e.jump, nothing}),
            // As it is evaluated: what is smooth on paper may lose its slope in floats.
            schedule(g, std::array{g.add(bounds_in_range(g, field.root), gaps(g, field.root)),
                                   anywhere(g, roughness(g, field.root, least_part_of_pieces))}),
            e.may_lack_values()};
}

Program derive_value(const Field& field) {
    Graph g = field.graph;
    g.fold_exactly();
    const NodeId root = with_chebyshev(g, field.root);
    return schedule(g, std::array{g.add(bounds_in_range(g, root), gaps(g, root))});
}

std::optional<Program> derive_hessian(const Field& field) {
    if (!degree(field.graph, field.root) || has_chebyshev(field.graph)) return {};
    Graph g = field.graph;
    g.fold_exactly();
    const NodeId along = differentiate_inputs(g, field.root, direction(g));
    const NodeId one = g.constant(1), zero = g.constant(0);
    std::vector<NodeId> outputs{field.root, along};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        std::vector<NodeId> directions(6, zero); // the ray's rests
        directions[axis] = one;
        outputs.push_back(differentiate_inputs(g, along, directions));
    }
    return schedule(g, outputs);
}

} // namespace

// Enclosures add nodes to a copy of the field's graph, whose own keep their numbers.
std::vector<NodeId> own_sums(const Field& field, int array) {
    return sums_over(field.graph, std::array{field.root}, array);
}

std::optional<EnclosuresApart> enclosures_apart(const Field& field, int array) {
    const Enclosed e(field);
    constexpr int place = 3, place_and_direction = 6;
    const auto apart = [&](std::span<const NodeId> roots, int places) {
        return sums_apart(e.graph, roots, array, places);
    };
    auto value = apart(std::array{e.value}, place);
    auto directional = apart(std::array{e.value, e.along}, place_and_direction);
    auto gradient = apart(e.gradient, place);
    auto jumps = apart(std::array{e.is_root, e.none}, place);
    if (!value || !directional || !gradient || !jumps) return std::nullopt;
    return EnclosuresApart{std::move(*value), std::move(*directional), std::move(*gradient),
                           std::move(*jumps), own_sums(field, array),  e.may_lack_values()};
}

const EnclosurePrograms& enclosure_programs(const Field& field) {
    return field.kept->programs.get([&] { return derive_programs(field); });
}

const Program& value_enclosure(const Field& field) {
    return field.kept->value.get([&] { return derive_value(field); });
}

const std::optional<Program>& hessian_program(const Field& field) {
    return field.kept->hessian.get([&] { return derive_hessian(field); });
}

} // namespace isomotion::formula

#include "topology/classify/morse_graph.h"

#include <algorithm>
#include <numeric>

namespace isomotion::topology {
namespace {

constexpr std::size_t nearest = 6, most_gaps = 400;

} // namespace

void MorseGraph::add(std::vector<SaddleConnection> connections) {
    for (SaddleConnection& connection : connections) {
        ends_.push_back({node(connection.paths[0]), node(connection.paths[1])});
        connections_.push_back(std::move(connection));
        is_closed_.push_back(false);
    }
}

int MorseGraph::node(const DescentPath& path) {
    if (path.end == DescentPath::End::outside) return 0;
    const SpacePoint& end = path.points.back();
    for (std::size_t k = 0; k < minima_.size(); ++k) {
        if (path.end == DescentPath::End::minimum && distance(minima_[k], end) <= same_)
            return int(k) + 1;
    }
    minima_.push_back(end);
    return int(minima_.size());
}

int MorseGraph::root(Parts& parts, int node) {
    while (parts[std::size_t(node)] != node)
        node = parts[std::size_t(node)] = parts[std::size_t(parts[std::size_t(node)])];
    return node;
}

std::optional<Route> MorseGraph::route(const DescentPath& from, const DescentPath& to) {
    if (from.end == DescentPath::End::lost || to.end == DescentPath::End::lost) return std::nullopt;
    const int first = node(from), last = node(to);
    // Kruskal's tree of the lowest passes, until it joins both.
    std::vector<std::size_t> by_height(connections_.size());
    std::iota(by_height.begin(), by_height.end(), std::size_t(0));
    std::ranges::stable_sort(by_height, {}, [&](std::size_t k) { return connections_[k].height; });
    Parts parts(minima_.size() + 1);
    std::iota(parts.begin(), parts.end(), 0);
    std::vector<std::vector<std::size_t>> tree(parts.size()); // passes at each node
    for (const std::size_t k : by_height) {
        if (root(parts, first) == root(parts, last)) break;
        const auto [a, b] = ends_[k];
        if (is_closed_[k] || root(parts, a) == root(parts, b)) continue;
        parts[std::size_t(root(parts, a))] = root(parts, b);
        tree[std::size_t(a)].push_back(k);
        tree[std::size_t(b)].push_back(k);
    }
    if (root(parts, first) != root(parts, last)) return std::nullopt;
    // The search goes back from the last node; each node knows by which pass it was reached.
    std::vector<std::size_t> by(parts.size(), Route::none);
    std::vector<int> reached{last};
    for (std::size_t next = 0; next < reached.size(); ++next) {
        const int here = reached[next];
        for (const std::size_t k : tree[std::size_t(here)]) {
            const int there = ends_[k][ends_[k][0] == here ? 1 : 0];
            if (there == last || by[std::size_t(there)] != Route::none) continue;
            by[std::size_t(there)] = k;
            reached.push_back(there);
        }
    }
    Route route;
    const auto add = [&](auto begin, auto end, std::size_t over) {
        route.points.insert(route.points.end(), begin, end);
        route.over.resize(route.points.size(), over);
    };
    add(from.points.begin(), from.points.end(), Route::none);
    for (int here = first; here != last;) {
        const std::size_t k = by[std::size_t(here)];
        const std::size_t up = ends_[k][0] == here ? 0 : 1;
        const auto& there = connections_[k].paths[up].points;
        const auto& onward = connections_[k].paths[1 - up].points; // both begin at the pass
        add(there.rbegin(), there.rend(), k);
        if (!onward.empty()) add(onward.begin() + 1, onward.end(), k);
        here = ends_[k][1 - up];
    }
    add(to.points.rbegin(), to.points.rend(), Route::none);
    return route;
}

std::vector<MorseGraph::Gap> MorseGraph::gaps(const DescentPath& from, const DescentPath& to,
                                              const Domain& domain) {
    std::array<int, 2> ends{node(from), node(to)};
    Parts parts(minima_.size() + 1);
    std::iota(parts.begin(), parts.end(), 0);
    for (std::size_t k = 0; k < connections_.size(); ++k) {
        if (is_closed_[k]) continue;
        parts[std::size_t(root(parts, ends_[k][0]))] = root(parts, ends_[k][1]);
    }
    const auto joined_to = [&](int end) {
        std::vector<int> nodes;
        for (int k = 0; k < int(parts.size()); ++k) {
            if (root(parts, k) == root(parts, end)) nodes.push_back(k);
        }
        return nodes;
    };
    std::array<std::vector<int>, 2> sides{joined_to(ends[0]), joined_to(ends[1])};
    const std::vector<int>& inner = sides[sides[0].size() <= sides[1].size() ? 0 : 1];
    const int part = root(parts, inner.front());
    std::vector<Gap> gaps;
    for (const int k : inner) {
        if (k == 0 || gaps.size() >= most_gaps) continue;
        const SpacePoint& here = minima_[std::size_t(k - 1)];
        std::vector<SpacePoint> others;
        for (int other = 1; other < int(parts.size()); ++other) {
            if (root(parts, other) != part) others.push_back(minima_[std::size_t(other - 1)]);
        }
        const std::size_t count = std::min(nearest, others.size());
        std::ranges::partial_sort(others, others.begin() + std::ptrdiff_t(count), {},
                                  [&](const SpacePoint& p) { return distance(here, p); });
        for (std::size_t n = 0; n < count; ++n) gaps.push_back({here, others[n]});
        if (domain.is_solid || root(parts, 0) == part) continue;
        for (std::size_t i = 0; i < 3; ++i) {
            const formula::Interval wall = domain.box[i];
            for (const double at :
                 {1.01 * wall.lo - 0.01 * wall.hi, 1.01 * wall.hi - 0.01 * wall.lo}) {
                SpacePoint out = here;
                out[i] = at;
                gaps.push_back({here, out});
            }
        }
    }
    return gaps;
}

} // namespace isomotion::topology

// Minima joined by saddle connections: the part of a field's Morse complex that tells which places
// below a level are connected (Edelsbrunner, Harer and Zomorodian 2003).
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "topology/classify/descent.h"

namespace isomotion::topology {

// A route goes down a path, over saddles and up another path.
struct Route {
    static constexpr std::size_t none = std::size_t(-1);
    std::vector<SpacePoint> points;
    std::vector<std::size_t> over; // for each point the connection it belongs to, or none
};

class MorseGraph {
public:
    // Minima closer to each other than `same` are identified.
    explicit MorseGraph(double same)
        : same_(same) {}

    void add(std::vector<SaddleConnection> connections);
    const SaddleConnection& connection(std::size_t number) const { return connections_[number]; }
    // Excludes a connection from all later routes.
    void close(std::size_t connection) { is_closed_[connection] = true; }

    // Joins the ends of two paths over the lowest possible saddles; empty if nothing joins them.
    std::optional<Route> route(const DescentPath& from, const DescentPath& to);

    // Gaps if there is no route. They lead from minima that are joined to one of the ends, the one
    // with fewer such minima, to the nearest minima that aren't, and out of the bounds.
    struct Gap {
        SpacePoint from, to;
    };
    std::vector<Gap> gaps(const DescentPath& from, const DescentPath& to, const Domain& domain);

private:
    using Parts = std::vector<int>; // a forest of nodes

    int node(const DescentPath& path);
    static int root(Parts& parts, int node);

    double same_;
    std::vector<SaddleConnection> connections_;
    std::vector<bool> is_closed_;
    std::vector<std::array<int, 2>> ends_; // of each connection
    std::vector<SpacePoint> minima_;       // nodes 1 and up; node 0 is the whole exterior
};

} // namespace isomotion::topology

// A regular cell complex: a box divided into boxes of any sizes, with their faces, edges and
// corners.
//
// Where boxes of two sizes meet, faces and edges are those of the smaller ones. Faces may be
// divided further without the boxes beside them, and edges without the faces. Let S be a subset of
// the box whose intersection with each cell is empty or contractible. Then S has the homotopy type
// of the cells that it meets, ordered by inclusion (docs/topology-frames.md). This class counts its
// Betti numbers.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "topology/timeline/betti.h"

namespace isomotion::topology {

// A cell. Along its own axes its length is the box's divided by 2^level; along the others it is a
// point.
struct CellKey {
    static constexpr int deepest = 30; // places are counted in 2^-30 of the box's sides
    static constexpr int whole = 1 << deepest;

    int level = 0;
    unsigned axes = 7; // bit k: along axis k
    std::array<int, 3> at{};

    int dimension() const;
    bool is_along(std::size_t axis) const { return axes >> axis & 1; }
    int length() const { return whole >> level; }
    int end(std::size_t axis) const { return at[axis] + (is_along(axis) ? length() : 0); }
    // Whether the cell lies on a wall of the box.
    bool is_on_wall() const;
    CellKey facet(std::size_t axis, bool high) const;
    std::vector<CellKey> facets() const;
    std::vector<CellKey> parts() const; // halved along all of its axes
    bool operator==(const CellKey&) const = default;
};

// The known relation of a cell to S.
struct CellFact {
    enum class Kind : char {
        unknown,
        outside, // S doesn't meet it
        inside,  // it is in S
        sinking, // S retracts in the cell, along a line from each point, to the facets on some
                 // sides
    };
    Kind kind = Kind::unknown;
    // For each axis the facet that S retracts to: -1 low, 1 high, 0 neither.
    std::array<signed char, 3> sinks_to{};
    // Whether the closed cell is outside or inside, so that each cell in it is, too.
    bool holds_of_closed_cell = false;
    // For each axis the facet that S retracts to along this axis alone, or 0, if it does so in each
    // cell along this axis in the closed cell.
    std::array<signed char, 3> sinks_along{};
};

class CellComplex {
public:
    // The relation of a cell to S; an unknown one is divided. Called once for each cell at most:
    // not where a cell beside tells.
    using Ask = std::function<CellFact(const CellKey&)>;
    explicit CellComplex(Ask ask)
        : ask_(std::move(ask)) {}

    // The number of cells whose relation to S is told or asked for, and how often the sides of
    // boxes and of faces may be halved. Edges may be shorter: where two surfaces cross, an edge
    // that passes the crossing must be about as short as its distance.
    struct Limits {
        std::size_t cells = 400'000;
        int depth = 17;
        int depth_of_edges = CellKey::deepest;
        std::function<bool()> stopped{};

        int depth_of(int dimension) const { return dimension == 1 ? depth_of_edges : depth; }
    };
    // The Betti numbers of S. Empty if the limits don't suffice, with the cell in `failed`.
    std::optional<Betti> betti(const Limits& limits);

    const CellKey& failed() const { return failed_; }
    std::size_t known() const { return known_; } // of the last count
    int depth() const { return depth_; }

private:
    struct Cell {
        CellFact fact;
        bool is_divided = false;
        bool is_listed = false; // or its parts are, if it is divided
        bool is_in_s = false;   // S meets it
        int number = 0;         // among the listed cells
    };
    using Cells = std::vector<CellKey>;
    // A key that identifies a cell.
    struct Packed {
        std::uint64_t first, second;
        bool operator==(const Packed&) const = default;
        bool operator<(const Packed& other) const {
            return first < other.first || (first == other.first && second < other.second);
        }
    };
    static Packed packed(const CellKey& key);

    // The cells, in one contiguous table, since looking them up dominates the time.
    class Table {
    public:
        Table();
        // Makes an entry if there is none. The reference is valid until another entry is made.
        Cell& operator[](const Packed& key);
        void list_none();

    private:
        struct Slot {
            Packed key = no_key;
            Cell cell;
        };
        // A key that no cell has: cells have axes, or are points on level 0.
        static constexpr Packed no_key{~std::uint64_t(0), ~std::uint64_t(0)};

        Slot& slot(const Packed& key);
        void grow();

        std::vector<Slot> slots_; // 2^bits_ of them, at least a third empty
        int bits_ = 0;
        std::size_t taken_ = 0;
    };

    Cell& cell(const CellKey& key); // as in Table
    void divide(const CellKey& key);
    // Lists what the cells are made of that were divided since the last call, and facets of these.
    bool list(const Limits& limits);
    void add(const CellKey& key);
    // What a cell tells of its facets.
    void tell_facets(const CellKey& key);
    // The undivided cells that make up a cell; the cell itself if it is undivided.
    void smallest(const CellKey& key, Cells& found);
    bool settle(const CellKey& key); // whether S meets it in something contractible
    // Divides the cells of the least dimension that has some which can't be settled. False if they
    // must not be divided.
    bool settle_listed(const Limits& limits);
    Betti count();

    Ask ask_;
    Table cells_;
    // By dimension. Of those listed, some may be divided since; some are not settled yet.
    std::array<Cells, 4> open_, listed_, unsettled_;
    CellKey failed_;
    std::size_t known_ = 0;
    int depth_ = 0;
};

} // namespace isomotion::topology

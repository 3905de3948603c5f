// A box divided into boxes of all sizes with their faces, edges and corners: a regular cell
// complex.
//
// Where boxes of two sizes meet, faces and edges are those of the smaller ones. Faces may be
// divided further without the boxes beside them, and edges without the faces. A subset S of the box
// that meets each cell in nothing or in something contractible has the homotopy type of the cells
// that it meets, ordered by inclusion (docs/topology-proofs.md), and its Betti numbers are counted
// here.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "topology/timeline/betti.h"

namespace isomotion::topology {

// A cell: it is as long as the box divided by 2^level along its axes, and a point along the others.
struct CellKey {
    static constexpr int deepest = 30; // places are counted in the box's 2^-30th parts
    static constexpr int whole = 1 << deepest;

    int level = 0;
    unsigned axes = 7; // bit k: along axis k
    std::array<int, 3> at{};

    int dimension() const;
    bool is_along(std::size_t axis) const { return axes >> axis & 1; }
    int length() const { return whole >> level; }
    int end(std::size_t axis) const { return at[axis] + (is_along(axis) ? length() : 0); }
    // On a wall of the box.
    bool is_on_wall() const;
    CellKey facet(std::size_t axis, bool high) const;
    std::vector<CellKey> facets() const;
    std::vector<CellKey> parts() const; // halved along all of its axes
    bool operator==(const CellKey&) const = default;
};

// What is known of a cell and S.
struct CellFact {
    enum class Kind : char {
        unknown,
        outside, // S doesn't meet it
        inside,  // it is in S
        sinking, // S sinks in it, along a line from each of its points, to the facets on some sides
    };
    Kind kind = Kind::unknown;
    // Along each axis the facet that S sinks to: -1 low, 1 high, 0 neither.
    std::array<signed char, 3> sinks_to{};
};

class CellComplex {
public:
    // What is so of a cell; unknown: it is divided. Asked once of each.
    using Ask = std::function<CellFact(const CellKey&)>;
    explicit CellComplex(Ask ask)
        : ask_(std::move(ask)) {}

    // Cells that may be asked for, and how often the sides of boxes and of faces are halved at
    // most. Edges may be shorter: where two surfaces cross, an edge that passes by has to be as
    // short as it is near.
    struct Limits {
        std::size_t cells = 400'000;
        int depth = 17;
        int depth_of_edges = CellKey::deepest;
        std::function<bool()> stopped{};

        int depth_of(int dimension) const { return dimension == 1 ? depth_of_edges : depth; }
    };
    // The Betti numbers of S; empty where the limits don't do, with the cell in `failed`.
    std::optional<Betti> betti(const Limits& limits);

    const CellKey& failed() const { return failed_; }
    std::size_t asked() const { return asked_; }
    int depth() const { return depth_; }

private:
    struct Cell {
        CellFact fact;
        bool is_divided = false, is_listed = false;
        bool is_in_s = false; // S meets it
        int number = 0;       // among the listed
    };
    using Cells = std::vector<CellKey>;
    // Tells cells apart.
    using Packed = std::array<std::uint64_t, 2>;
    static Packed packed(const CellKey& key);

    // The cells that were asked for, in one piece of memory: finding them is what takes the time.
    class Table {
    public:
        Table();
        // A new one where there is none. Holds until another one is made.
        Cell& operator[](const Packed& key);
        void list_none();

    private:
        struct Slot {
            Packed key = no_key;
            Cell cell;
        };
        // No cell's: they have axes, or are points on level 0.
        static constexpr Packed no_key{~std::uint64_t(0), ~std::uint64_t(0)};

        Slot& slot(const Packed& key);
        void grow();

        std::vector<Slot> slots_; // 2^bits_ of them, at least a third empty
        int bits_ = 0;
        std::size_t taken_ = 0;
    };

    Cell& cell(const CellKey& key); // as Table's
    bool list(const Limits& limits);
    void add(const CellKey& key);
    // The undivided cells that a cell is made of, itself where it is one.
    void smallest(const CellKey& key, Cells& found);
    bool settle(const CellKey& key); // whether S meets it, and in something contractible
    Betti count();

    Ask ask_;
    Table cells_;
    std::array<Cells, 4> listed_; // by dimension
    CellKey failed_;
    std::size_t asked_ = 0;
    int depth_ = 0;
};

} // namespace isomotion::topology

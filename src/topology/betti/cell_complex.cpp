#include "topology/betti/cell_complex.h"

#include <algorithm>
#include <bit>
#include <map>
#include <numeric>
#include <span>
#include <utility>

namespace isomotion::topology {
namespace {

class UnionFind {
public:
    explicit UnionFind(std::size_t count)
        : parent_(count) {
        std::iota(parent_.begin(), parent_.end(), std::size_t(0));
    }
    std::size_t root(std::size_t k) {
        while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
        return k;
    }
    // True if they were apart.
    bool unite(std::size_t a, std::size_t b) {
        a = root(a);
        b = root(b);
        parent_[a] = b;
        return a != b;
    }

private:
    std::vector<std::size_t> parent_;
};

int sign_of_dimension(const CellKey& key) { return key.dimension() % 2 == 0 ? 1 : -1; }

} // namespace

int CellKey::dimension() const { return std::popcount(axes); }

bool CellKey::is_on_wall() const {
    for (std::size_t k = 0; k < 3; ++k) {
        if (!is_along(k) && (at[k] == 0 || at[k] == whole)) return true;
    }
    return false;
}

CellKey CellKey::facet(std::size_t axis, bool high) const {
    CellKey made = *this;
    made.axes &= ~(1u << axis);
    if (high) made.at[axis] += length();
    return made;
}

std::vector<CellKey> CellKey::facets() const {
    std::vector<CellKey> all;
    for (std::size_t k = 0; k < 3; ++k) {
        if (!is_along(k)) continue;
        all.push_back(facet(k, false));
        all.push_back(facet(k, true));
    }
    return all;
}

std::vector<CellKey> CellKey::parts() const {
    CellKey half = *this;
    ++half.level;
    std::vector<CellKey> all{half};
    for (std::size_t k = 0; k < 3; ++k) {
        if (!is_along(k)) continue;
        for (std::size_t j = 0, count = all.size(); j < count; ++j) {
            CellKey other = all[j];
            other.at[k] += half.length();
            all.push_back(other);
        }
    }
    return all;
}

CellComplex::Packed CellComplex::packed(const CellKey& key) {
    const std::uint64_t level = key.axes == 0 ? 0 : std::uint64_t(key.level);
    return {level << 35 | std::uint64_t(key.axes) << 32 | std::uint64_t(key.at[0]),
            std::uint64_t(key.at[1]) << 32 | std::uint64_t(key.at[2])};
}

CellComplex::Table::Table() { grow(); }

// The slot of a key is searched for from the high bits of a product, which Fibonacci's multiplier
// mixes best, and on to the next ones.
CellComplex::Table::Slot& CellComplex::Table::slot(const Packed& key) {
    constexpr std::uint64_t golden = 0x9e3779b97f4a7c15;
    const std::uint64_t mixed = (key.first * golden ^ key.second) * golden;
    for (std::size_t at = std::size_t(mixed >> (64 - bits_));; at = (at + 1) % slots_.size()) {
        Slot& here = slots_[at];
        if (here.key == key || here.key == no_key) return here;
    }
}

CellComplex::Cell& CellComplex::Table::operator[](const Packed& key) {
    Slot* found = &slot(key);
    if (found->key == key) return found->cell;
    if (3 * (taken_ + 1) > 2 * slots_.size()) {
        grow();
        found = &slot(key);
    }
    ++taken_;
    found->key = key;
    return found->cell;
}

void CellComplex::Table::grow() {
    bits_ = bits_ == 0 ? 10 : bits_ + 1;
    const std::vector<Slot> before = std::move(slots_);
    slots_.assign(std::size_t(1) << bits_, {});
    for (const Slot& old : before) {
        if (old.key != no_key) slot(old.key) = old;
    }
}

void CellComplex::Table::list_none() {
    for (Slot& slot : slots_) slot.cell.is_listed = false;
}

CellComplex::Cell& CellComplex::cell(const CellKey& key) { return cells_[packed(key)]; }

// What it is made of is to be listed in its place.
void CellComplex::divide(const CellKey& key) {
    Cell& now = cell(key);
    now.is_divided = true;
    if (std::exchange(now.is_listed, false)) open_[std::size_t(key.dimension())].push_back(key);
}

// Whatever a new cell is a part of is divided.
void CellComplex::add(const CellKey& key) {
    cell(key);
    if (key.axes == 0) return;
    for (CellKey whole = key; whole.level > 0;) {
        --whole.level;
        for (std::size_t k = 0; k < 3; ++k) {
            if (whole.is_along(k)) whole.at[k] &= ~(whole.length() - 1);
        }
        if (cell(whole).is_divided) return;
        divide(whole);
    }
}

void CellComplex::smallest(const CellKey& key, Cells& found) {
    if (!cell(key).is_divided) {
        found.push_back(key);
        return;
    }
    for (const CellKey& part : key.parts()) smallest(part, found);
}

void CellComplex::tell_facets(const CellKey& key) {
    const CellFact told = cell(key).fact;
    if (!told.holds_of_closed_cell && told.sinks_along == decltype(told.sinks_along){}) return;
    Cells parts;
    for (const CellKey& facet : key.facets()) smallest(facet, parts);
    for (const CellKey& part : parts) {
        CellFact& fact = cell(part).fact;
        if (fact.kind == CellFact::Kind::outside || fact.kind == CellFact::Kind::inside) continue;
        if (told.holds_of_closed_cell) {
            fact = told;
            continue;
        }
        for (std::size_t k = 0; k < 3; ++k) {
            if (!part.is_along(k) || told.sinks_along[k] == 0) continue;
            fact.sinks_along[k] = told.sinks_along[k];
            if (fact.kind != CellFact::Kind::unknown) continue;
            fact.kind = CellFact::Kind::sinking;
            fact.sinks_to[k] = told.sinks_along[k];
        }
    }
}

bool CellComplex::list(const Limits& limits) {
    for (int dimension = 3; dimension >= 0; --dimension) {
        const auto d = std::size_t(dimension);
        Cells &open = open_[d], &listed = listed_[d];
        const std::size_t before = listed.size();
        while (!open.empty()) {
            const CellKey key = open.back();
            open.pop_back();
            Cell& now = cell(key);
            if (now.is_listed) continue;
            now.is_listed = true;
            if (!now.is_divided) {
                failed_ = key;
                if (++known_ > limits.cells || (limits.stopped && limits.stopped())) return false;
                if (now.fact.kind == CellFact::Kind::unknown) now.fact = ask_(key);
                depth_ = std::max(depth_, key.level);
                if (now.fact.kind == CellFact::Kind::unknown) {
                    if (dimension == 0 || key.level >= limits.depth_of(dimension)) return false;
                    now.is_divided = true;
                }
            }
            if (now.is_divided) {
                for (const CellKey& part : key.parts()) open.push_back(part);
            } else {
                listed.push_back(key);
            }
        }
        const auto fresh = std::span(listed).subspan(before);
        unsettled_[d].insert(unsettled_[d].end(), fresh.begin(), fresh.end());
        for (const CellKey& key : fresh) {
            for (const CellKey& facet : key.facets()) {
                add(facet);
                open_[d - 1].push_back(facet);
            }
        }
        for (const CellKey& key : fresh) tell_facets(key);
    }
    return true;
}

// A cell in which S sinks holds of S what the facets hold that S sinks to. These facets are a disc,
// an arc or a point; they hold of S what their cells that S meets make up.
bool CellComplex::settle(const CellKey& key) {
    const CellFact fact = cell(key).fact;
    if (fact.kind != CellFact::Kind::sinking) {
        cell(key).is_in_s = fact.kind == CellFact::Kind::inside;
        return true;
    }
    const auto is_on_other_facet = [&](const CellKey& part) {
        for (std::size_t k = 0; k < 3; ++k) {
            if (!key.is_along(k) || part.is_along(k)) continue;
            if (part.at[k] == key.at[k] && fact.sinks_to[k] != -1) return true;
            if (part.at[k] == key.end(k) && fact.sinks_to[k] != 1) return true;
        }
        return false;
    };
    Cells open;
    for (std::size_t k = 0; k < 3; ++k) {
        if (fact.sinks_to[k] != 0) smallest(key.facet(k, fact.sinks_to[k] > 0), open);
    }
    std::map<Packed, std::size_t> number;
    std::vector<std::pair<std::size_t, std::size_t>> incident;
    int euler = 0;
    for (std::size_t next = 0; next < open.size(); ++next) {
        const CellKey part = open[next];
        if (!cell(part).is_in_s) continue;
        const auto [at, is_new] = number.try_emplace(packed(part), number.size());
        if (!is_new) continue;
        if (!is_on_other_facet(part)) euler += sign_of_dimension(part);
        Cells facets;
        for (const CellKey& facet : part.facets()) smallest(facet, facets);
        for (const CellKey& facet : facets) {
            if (!cell(facet).is_in_s) continue;
            open.push_back(facet);
        }
    }
    cell(key).is_in_s = !number.empty();
    if (number.empty()) return true;
    UnionFind together(number.size());
    std::size_t components = number.size();
    for (const CellKey& part : open) {
        const auto at = number.find(packed(part));
        if (at == number.end()) continue;
        Cells facets;
        for (const CellKey& facet : part.facets()) smallest(facet, facets);
        for (const CellKey& facet : facets) {
            const auto other = number.find(packed(facet));
            if (other != number.end() && together.unite(at->second, other->second)) --components;
        }
    }
    if (key.dimension() < 3) return components == 1;
    return components == 1 && euler == 1;
}

// The cells that S meets, less those that it doesn't, are a part X of the box B: chi(X) is
// chi_c(X on B's walls) - chi_c(X), for X is a manifold of three dimensions; b_2 counts, by
// Alexander's duality, what X parts the rest into, all that is outside of B being one.
Betti CellComplex::count() {
    for (Cells& cells : listed_) {
        std::erase_if(cells, [&](const CellKey& key) { return cell(key).is_divided; });
        for (std::size_t k = 0; k < cells.size(); ++k) cell(cells[k]).number = int(k);
    }
    std::array<std::size_t, 5> first{}; // number of the first cell of each dimension
    for (std::size_t d = 0; d < 4; ++d) first[d + 1] = first[d] + listed_[d].size();
    const std::size_t count = first[4], outside = count;
    UnionFind met(count + 1), unmet(count + 1);
    std::size_t components = 0, voids = 1;
    int euler = 0;
    for (std::size_t d = 0; d < 4; ++d) {
        for (const CellKey& key : listed_[d]) {
            const Cell now = cell(key);
            const std::size_t number = first[d] + std::size_t(now.number);
            const bool is_on_wall = key.is_on_wall();
            if (now.is_in_s) {
                ++components;
                if (!is_on_wall) euler -= sign_of_dimension(key);
            }
            const bool is_unmet = !now.is_in_s || is_on_wall;
            if (is_unmet) ++voids;
            if (is_on_wall && unmet.unite(number, outside)) --voids;
            Cells facets;
            for (const CellKey& facet : key.facets()) smallest(facet, facets);
            for (const CellKey& facet : facets) {
                const Cell of = cell(facet);
                const std::size_t other = first[d - 1] + std::size_t(of.number);
                if (now.is_in_s && of.is_in_s && met.unite(number, other)) --components;
                if (is_unmet && (!of.is_in_s || facet.is_on_wall()) && unmet.unite(number, other))
                    --voids;
            }
        }
    }
    Betti betti;
    betti.components = int(components);
    betti.voids = int(voids) - 1;
    betti.tunnels = betti.components + betti.voids - euler;
    return betti;
}

// What is settled remains so, however finely its facets are divided.
bool CellComplex::settle_listed(const Limits& limits) {
    for (Cells& cells : unsettled_) { // ascending dimension
        bool is_settled = true;
        for (const CellKey& key : cells) {
            if (cell(key).is_divided) continue;
            if (settle(key)) continue;
            failed_ = key;
            if (key.level >= limits.depth_of(key.dimension())) return false;
            divide(key);
            is_settled = false;
        }
        cells.clear();
        if (!is_settled) break;
    }
    return true;
}

std::optional<Betti> CellComplex::betti(const Limits& limits) {
    cells_.list_none();
    known_ = 0;
    for (auto* cells : {&open_, &listed_, &unsettled_}) *cells = {};
    open_[3] = {CellKey{}};
    do {
        if (!list(limits) || !settle_listed(limits)) return std::nullopt;
    } while (std::ranges::any_of(open_, [](const Cells& cells) { return !cells.empty(); }));
    return count();
}

} // namespace isomotion::topology

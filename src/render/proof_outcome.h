// How the proof of a pixel's ray ended.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace isomotion::render {

// The codes of the channel proof.
enum class Proof {
    none, // the march ended with neither a root nor a miss, or rays are beyond the range of float32
    hit,  // proved
    miss, // proved
    hidden,    // there may be a root before the one found, or on a ray without one
    sign,      // F may not change its sign where the root was found, or more than once
    budget,    // too many pieces
    unbounded, // F or its slope is unbounded on some piece
};
inline constexpr std::array<std::string_view, 7> proof_names{
    "not looked at", "hit", "miss", "may be hidden", "sign undecided", "budget", "unbounded"};
using ProofCounts = std::array<std::int64_t, proof_names.size()>; // of pixels, by Proof

// Counts outcomes of four numbers each, the first of which is a Proof.
ProofCounts count_proofs(std::span<const float> record);
constexpr bool is_proved(Proof proof) { return proof == Proof::hit || proof == Proof::miss; }
double proved_part(const ProofCounts& counts); // 0 to 1
// "proved 99.3 %; not proved: 0.5 % sign undecided, 0.2 % may be hidden"
std::string summary(const ProofCounts& counts);

} // namespace isomotion::render

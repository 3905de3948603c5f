// The data that a frame can hold besides the picture itself.
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace isomotion::shader {

enum class Channel {
    depth,
    normal,
    position,
    verdict,
    evaluations,
    velocity,
    proof,
    cap,
    surface,
    ending, // the data that a proof needs of a ray; not a layer of a file
};

struct ChannelName {
    Channel channel;
    std::string_view name;                // on the command line
    std::vector<std::string_view> layers; // in an EXR file
};

inline const std::vector<ChannelName>& channel_names() {
    static const std::vector<ChannelName> names{
        {Channel::depth, "z", {"Z"}},
        {Channel::normal, "n", {"N.X", "N.Y", "N.Z"}},
        {Channel::position, "p", {"P.X", "P.Y", "P.Z"}},
        {Channel::verdict, "verdict", {"verdict"}},
        {Channel::evaluations, "evaluations", {"evaluations"}},
        {Channel::velocity, "velocity", {"velocity.N", "velocity.X", "velocity.Y"}},
        {Channel::proof, "proof", {"proof", "proof.T"}},
        {Channel::cap, "cap", {"cap"}},
        {Channel::surface, "surface", {"surface"}},
    };
    return names;
}

inline std::optional<Channel> parse_channel(std::string_view text) {
    for (const auto& entry : channel_names()) {
        if (entry.name == text) return entry.channel;
    }
    return std::nullopt;
}

} // namespace isomotion::shader

#include "ply.h"

#include <bit>
#include <cstdint>
#include <string>

namespace water {
namespace {

void put(std::vector<std::byte>& bytes, std::uint32_t word) {
    for (int shift = 0; shift < 32; shift += 8) bytes.push_back(std::byte(word >> shift & 0xFF));
}

void put(std::vector<std::byte>& bytes, float value) {
    put(bytes, std::bit_cast<std::uint32_t>(value));
}

std::string header_of(std::size_t count) {
    std::string text = "ply\nformat binary_little_endian 1.0\ncomment made by make_water\n"
                       "element vertex " +
                       std::to_string(count) + "\n";
    for (const char* name : {"x", "y", "z", "vx", "vy", "vz"})
        text += std::string("property float ") + name + "\n";
    text += "property int id\n";
    for (const char* name : {"gxx", "gxy", "gxz", "gyy", "gyz", "gzz", "w"})
        text += std::string("property float ") + name + "\n";
    return text + "end_header\n";
}

} // namespace

std::vector<std::byte> ply_of(std::span<const Blob> blobs) {
    std::vector<std::byte> bytes;
    bytes.reserve(512 + blobs.size() * 56);
    for (const char c : header_of(blobs.size())) bytes.push_back(std::byte(c));
    for (std::size_t i = 0; i < blobs.size(); ++i) {
        const Blob& blob = blobs[i];
        for (const Vec3& v : {blob.centre, blob.velocity}) {
            put(bytes, v.x);
            put(bytes, v.y);
            put(bytes, v.z);
        }
        put(bytes, std::uint32_t(i));
        for (const float g : blob.g) put(bytes, g);
        put(bytes, blob.weight);
    }
    return bytes;
}

} // namespace water

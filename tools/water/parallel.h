#pragma once

#include <algorithm>
#include <atomic>
#include <cstddef>
#include <thread>
#include <vector>

namespace water {

/// How many indices a thread takes at a time.
inline constexpr std::size_t chunk_size = 512;

inline std::size_t chunks_of(std::size_t count) { return (count + chunk_size - 1) / chunk_size; }

/// Calls body(chunk, first, last) for all chunks of [0, count). A body writes only what belongs to
/// its indices: then the result is the same whatever the number of threads. It must not throw.
template<class Body> void for_chunks(std::size_t count, unsigned threads, const Body& body) {
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t c = next++; c < chunks_of(count); c = next++)
            body(c, c * chunk_size, std::min(count, (c + 1) * chunk_size));
    };
    std::vector<std::jthread> others;
    for (unsigned k = 1; k < std::min<std::size_t>(threads, chunks_of(count)); ++k)
        others.emplace_back(work);
    work();
}

/// Calls body(i) for all i in [0, count), under the same conditions.
template<class Body> void for_all(std::size_t count, unsigned threads, const Body& body) {
    for_chunks(count, threads, [&](std::size_t, std::size_t first, std::size_t last) {
        for (std::size_t i = first; i < last; ++i) body(i);
    });
}

} // namespace water

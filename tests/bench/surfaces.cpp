// What the surfaces of a scene cost together, and each alone.
//
//     surfaces_bench SCENE [PIXELS] [ROUNDS] [FRAME]
//
// Draws a frame of PIXELS x PIXELS with all surfaces and of each alone, in turn. Times are the
// processor's, medians of ROUNDS rounds. Evaluations are those that pictures count: not those of a
// mirror's rays, but for paths among glass.
#include <algorithm>
#include <cstdlib>
#include <ctime>
#include <memory>
#include <vector>

#include <fmt/format.h>

#include "gpu/context.h"
#include "render/renderer.h"
#include "scene/reading/load.h"
#include "scene/surfaces.h"

namespace {

using namespace isomotion;

struct Drawn {
    Drawn(gpu::Context& context, const scene::Scene& drawn, int pixels, int frame)
        : renderer(context, drawn, {pixels, pixels})
        , inputs(renderer.prepare(drawn, frame)) {
        draw(); // drivers make their code at the first draw
    }

    // Milliseconds of the processor.
    double draw() {
        const std::clock_t start = std::clock();
        const render::Picture picture = renderer.draw(inputs.pictures.front());
        evaluations = picture.evaluations();
        return 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
    }

    double median() {
        const auto middle = times.begin() + std::ptrdiff_t(times.size() / 2);
        std::nth_element(times.begin(), middle, times.end());
        return *middle;
    }

    render::Renderer renderer;
    render::FrameInputs inputs;
    std::int64_t evaluations = 0;
    std::vector<double> times;
};

} // namespace

int main(int count, char** words) {
    if (count < 2) {
        fmt::print(stderr, "usage: surfaces_bench SCENE [PIXELS] [ROUNDS] [FRAME]\n");
        return 2;
    }
    const auto number = [&](int k, int usual) { return count > k ? std::atoi(words[k]) : usual; };
    const int pixels = number(2, 512), rounds = number(3, 21), frame = number(4, 1);
    setenv("ISOMOTION_DATA", ISOMOTION_SOURCE_DIR, /*overwrite=*/1);
    const scene::Scene scene = scene::load(words[1]);
    const auto context = gpu::Context::create();

    std::vector<std::unique_ptr<Drawn>> all;
    all.push_back(std::make_unique<Drawn>(*context, scene, pixels, frame));
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        all.push_back(std::make_unique<Drawn>(*context, scene::alone({scene, k}), pixels, frame));
    }
    for (int round = 0; round < rounds; ++round) {
        for (const auto& one : all) one->times.push_back(one->draw());
    }
    double sum = 0;
    std::int64_t evaluations = 0;
    for (std::size_t k = 0; k < scene.surfaces.size(); ++k) {
        Drawn& one = *all[k + 1];
        sum += one.median();
        evaluations += one.evaluations;
        fmt::print("{:12} {:9.2f} ms {:12} evaluations\n", scene::surface_names(scene)[k],
                   one.median(), one.evaluations);
    }
    Drawn& together = *all.front();
    fmt::print(
        "{:12} {:9.2f} ms {:12} evaluations\n{:12} {:9.2f} ms {:12} evaluations, {:.3f} times "
        "the sum\n",
        "sum", sum, evaluations, "together", together.median(), together.evaluations,
        together.median() / sum);
}

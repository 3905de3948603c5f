// What --certify proves and what it takes: every surface of the catalogue by the method hermite,
// with proofs and without, as Markdown.
//
//   proofs_bench [--only SURFACE,...] [--size N] [--repeat N] [--backend NAME] [--processor]
//
// Proofs are compared with certified truth, which is remembered from run to run. With --processor
// they are not, and times are the processor's, the least of all: for machines with other work.

#include <algorithm>
#include <cmath>
#include <ctime>

#include <fmt/format.h>

#include "accuracy/truth_cache.h"
#include "machine.h"
#include "methods/contest.h"
#include "scene/data_folder.h"
#include "words.h"

namespace isomotion::bench {
namespace {

using render::Proof;

struct Arguments {
    std::vector<std::string> only;
    std::string backend = "auto";
    int size = 512, repeat = 5;
    bool processor = false;
};

// The processor's milliseconds for a surface, each the least of all rounds.
void run_by_processor(const Arguments& arguments, gpu::Context& context,
                      const std::vector<std::string>& names) {
    fmt::print("| surface | ms | ms with proofs | times | proved % |\n|---|--:|--:|--:|--:|\n");
    double logarithms = 0;
    for (const std::string& name : names) {
        Certified plain = uncertified(surface(name), arguments.size);
        std::vector<std::unique_ptr<render::Renderer>> renderers;
        for (const bool certify : {false, true}) {
            plain.subject.scene.surfaces[0].isolation.certify = certify;
            renderers.push_back(std::make_unique<render::Renderer>(
                context, plain.subject.scene,
                render::RenderOptions{plain.width(), plain.height()}));
        }
        std::array<double, 2> least{1e9, 1e9};
        render::ProofCounts proofs{};
        for (int round = 0; round <= arguments.repeat; ++round) {
            for (const std::size_t k : {0u, 1u}) {
                const std::clock_t start = std::clock();
                render::Picture picture = renderers[k]->draw(plain.frames[0]);
                const double ms = 1000.0 * double(std::clock() - start) / CLOCKS_PER_SEC;
                // Drivers make their code at the first draw.
                if (round > 0) least[k] = std::min(least[k], ms);
                if (k == 1) proofs = picture.proofs;
                renderers[k]->reuse(std::move(picture));
            }
        }
        logarithms += std::log(least[1] / least[0]);
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.4f} |\n", name, least[0], least[1],
                   least[1] / least[0], 100 * render::proved_part(proofs));
        std::fflush(stdout);
    }
    fmt::print("\n{} surfaces: {:.2f} times in the geometric mean\n", names.size(),
               std::exp(logarithms / double(names.size())));
}

// The proofs of a picture, compared with truth.
accuracy::Errors held_against_truth(gpu::Context& context, const Certified& on,
                                    const accuracy::Setting& setting) {
    using shader::Channel;
    const scene::Scene scene = accuracy::apply(setting, on.subject.scene);
    render::Renderer renderer(
        context, scene,
        {on.width(),
         on.height(),
         {Channel::normal, Channel::position, Channel::verdict, Channel::proof},
         {}});
    return accuracy::compare(on.frames[0], renderer.draw(on.frames[0]).frame, on.truths[0]);
}

void run(const Arguments& arguments) {
    const auto context = gpu::Context::create(gpu::parse_backend(arguments.backend));
    fmt::print("{}, {}, {} x {} pixels\n\n", machine(context->info()), today(), arguments.size,
               arguments.size);
    const auto names = arguments.only.empty() ? scene::surface_names() : arguments.only;
    if (arguments.processor) return run_by_processor(arguments, *context, names);
    fmt::print(
        "| surface | ms | ms with proofs | times | proved % | hidden % | sign % | budget % | "
        "unbounded % | none % | contradicted |\n|---|--:|--:|--:|--:|--:|--:|--:|--:|--:|--:|\n");
    int enough = 0, cheap = 0, both = 0, all = 0;
    double logarithms = 0;
    std::int64_t contradicted = 0;
    for (const std::string& name : names) {
        const Certified plain =
            certified(surface(name), arguments.size, accuracy::truth_cache_folder());
        Certified proved = plain;
        proved.subject.scene.surfaces[0].isolation.certify = true;
        const scene::Isolation& own = plain.subject.scene.surfaces[0].isolation;
        const accuracy::Setting setting{scene::Method::hermite, own.step, 1, own.bisections,
                                        own.safety};
        const accuracy::Errors errors = held_against_truth(*context, proved, setting);
        const std::vector<Timing> timings =
            race(*context, std::array{Entrant{&plain, setting}, Entrant{&proved, setting}},
                 arguments.repeat);
        const double times = ratio(timings[1], timings[0]);
        const double part = render::proved_part(errors.proofs);
        const auto percent = [&](Proof proof) {
            return 100 * double(errors.proofs[std::size_t(proof)]) / double(errors.pixels);
        };
        fmt::print("| {} | {:.2f} | {:.2f} | {:.2f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | {:.3f} | "
                   "{:.3f} | {} |\n",
                   name, timings[0].ms, timings[1].ms, times, 100 * part, percent(Proof::hidden),
                   percent(Proof::sign), percent(Proof::budget), percent(Proof::unbounded),
                   percent(Proof::none), errors.contradicted);
        std::fflush(stdout);
        ++all;
        enough += part >= 0.99;
        cheap += times <= 3;
        both += part >= 0.99 && times <= 3;
        logarithms += std::log(times);
        contradicted += errors.contradicted;
    }
    fmt::print("\n{} surfaces: 99 % are proved on {}, for at most three times the time on {}, both "
               "on {}; {:.2f} times in the geometric mean; {} proofs contradicted\n",
               all, enough, cheap, both, std::exp(logarithms / all), contradicted);
}

} // namespace
} // namespace isomotion::bench

int main(int argc, char** argv) {
    isomotion::bench::Arguments arguments;
    isomotion::bench::Words words("what proofs take, and how much they prove");
    words.texts("--only", arguments.only, "surfaces a,b (default: all)");
    words.number("--size", arguments.size, "pixels a side", {8, 4096});
    words.number("--repeat", arguments.repeat, "frames a median is taken of", {1, 1000});
    words.text("--backend", arguments.backend, "auto, egl or osmesa");
    words.flag("--processor", arguments.processor, "the processor's time, without truth");
    if (const auto code = words.read(argc, argv)) return *code;
    try {
        isomotion::bench::run(arguments);
    } catch (const std::exception& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 1;
    }
}

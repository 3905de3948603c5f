// Two balls meet: draws the last frame, proves where the middle ray hits, and when they merge.
#include <iostream>

#include <isomotion/render.h>
#include <isomotion/scene.h>
#include <isomotion/topology.h>
#include <isomotion/truth.h>

using namespace isomotion;

namespace {

void draw(const scene::Scene& scene, const scene::SceneAt& now, const char* file) {
    const auto context = gpu::Context::create();
    render::RenderOptions options;
    options.width = scene.output.width;
    options.height = scene.output.height;
    render::Renderer renderer(*context, scene, options);

    const render::Picture picture = renderer.draw(now);
    base::write_whole(file, image::encode(picture.frame, image::format_of(file)));
    std::cout << file << ": " << picture.verdicts[std::size_t(render::Verdict::hit)] << " of "
              << options.width * options.height << " rays hit\n";
}

void print_middle(const truth::Truth& truth) {
    const truth::FirstRoot& root = truth.at(truth.width / 2, truth.height / 2);
    if (root.answer == truth::Answer::hit) {
        std::cout << "the middle ray's first root is in [" << root.low << ", " << root.high
                  << "]\n";
    }
}

void print_events(const topology::Timeline& timeline) {
    for (const topology::Event& event : timeline.events) {
        std::cout << topology::name(event.kind) << " at t in [" << event.time.lo << ", "
                  << event.time.hi << "]" << (event.is_proved ? ", proved\n" : "\n");
    }
    std::cout << (timeline.is_complete() ? "nothing else happens\n" : "not all is known\n");
}

} // namespace

int main(int count, char** words) try {
    const scene::Scene scene = scene::load(count > 1 ? words[1] : "meeting.toml");
    const scene::SceneAt last = scene::at(scene, scene.timeline.values(scene.timeline.frames));
    std::cout.precision(10);

    draw(scene, last, "meeting.png");
    print_middle(truth::certify(scene, last, 64, 64));
    print_events(topology::analyse(scene));
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

// Two balls meet: draws the last frame, proves where the middle ray hits, and when they merge.
#include <iostream>

#include <isomotion/isomotion.h>

using namespace isomotion;

namespace {

void draw(const Scene& scene, const char* file) {
    Device device;
    const Picture picture = Renderer(device, scene).draw(scene.frames());
    picture.write(file);
    std::cout << file << ": " << picture.hits << " of " << picture.width * picture.height
              << " rays hit\n";
}

void print_middle(const Scene& scene) {
    constexpr int side = 64;
    const auto roots = first_roots(scene, scene.frames(), side, side);
    const FirstRoot& middle = roots[side * side / 2 + side / 2];
    if (middle.answer == FirstRoot::Answer::hit) {
        std::cout << "the middle ray's first root is in [" << middle.root.low << ", "
                  << middle.root.high << "]\n";
    }
}

void print_events(const Topology& found) {
    for (const TopologyEvent& event : found.events) {
        std::cout << event.kind << " at t in [" << event.time.low << ", " << event.time.high << "]"
                  << (event.proved ? ", proved\n" : "\n");
    }
    std::cout << (found.complete ? "nothing else happens\n" : "not all is known\n");
}

} // namespace

int main(int count, char** words) try {
    const Scene scene = Scene::load(count > 1 ? words[1] : "meeting.toml");
    std::cout.precision(10);

    draw(scene, "meeting.png");
    print_middle(scene);
    print_events(topology_of(scene));
    return 0;
} catch (const Error& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

#include <exception>

#include "fuzz/targets.h"
#include "scene/reading/load.h"
#include "scene/scene_at.h"
#include "shader/assemble.h"

namespace isomotion::fuzz {

void scene(std::string_view text) {
    try {
        const scene::Scene scene = scene::load_text(text, ISOMOTION_FUZZ_FOLDER "/scene.toml");
        for (const int frame : {1, 2, scene.timeline.frames}) {
            scene::at_frame(scene, frame);
        }
        shader::assemble(scene, {shader::Channel::normal, shader::Channel::velocity});
        shader::assemble(scene, {}, {shader::Stage::compute});
    } catch (const scene::SceneError& error) {
        if (base::printable(error.what()) != error.what()) {
            throw Violation("a message that commands a terminal");
        }
    } catch (const std::length_error&) {
    }
    for (const char* file : {"/scene.jsurf", "/scene.pov", "/scene.json"}) { // of other programs
        try {
            scene::load_text(text, std::string(ISOMOTION_FUZZ_FOLDER) + file);
        } catch (const scene::SceneError& error) {
            if (base::printable(error.what()) != error.what()) {
                throw Violation("a message that commands a terminal");
            }
        } catch (const std::length_error&) {
        }
    }
}

} // namespace isomotion::fuzz

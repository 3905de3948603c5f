#include "app/gallery_inputs.h"

#include "scene/data_folder.h"
#include "scene/error.h"
#include "scene/files_read.h"
#include "scene/reading/load.h"

namespace isomotion::app {

sequence::Inputs gallery_inputs() {
    sequence::Inputs inputs{std::vector<std::filesystem::path>()};
    for (const std::string& name : scene::animation_names()) {
        inputs.add(scene::animation_file(name));
        try {
            for (const auto& file : scene::files_read(scene::load(name))) inputs.add(file);
        } catch (const scene::SceneError&) { // its own file is known
        }
    }
    return inputs;
}

} // namespace isomotion::app

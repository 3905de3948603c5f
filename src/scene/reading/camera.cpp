#include "scene/reading/camera.h"

#include "scene/key_tables.h"
#include "scene/reading/read_keys.h"

namespace isomotion::scene {

Camera read_camera(Section& document, TrackTable& tracks) {
    const toml::table none;
    auto given = document.section("camera");
    Section section = given ? *given : Section(none, "camera", document.mistakes());
    Camera camera;
    read_keys(keys::camera_keys, section, camera, tracks);
    const auto refuse = [&](const char* name, const char* why) {
        if (section.has(name)) section.tell(name, why);
    };
    if (section.has("position")) {
        for (const char* name : {"azimuth", "elevation", "distance"}) {
            refuse(name, "is of a camera on an orbit; this one has a position. Give one or the "
                         "other");
        }
        // A camera that stands somewhere looks at the origin of the world.
        if (!camera.target) camera.target = tracks.add("camera.target", 0, 0, 0);
    }
    if (camera.projection == Camera::Projection::perspective && !section.is_wrong("projection")) {
        refuse("height", "is of an orthographic camera: projection = \"orthographic\"; this one "
                         "has fov");
    }
    if (!section.has("aperture"))
        refuse("focus", "is of a camera with a lens: give its diameter, aperture, too");
    section.refuse_rest();
    return camera;
}

} // namespace isomotion::scene

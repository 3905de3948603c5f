#pragma once

namespace isomotion::scene {

// Which files a scene may name (named_file.h).
enum class Reach {
    own_folder, // and the program's animations/ and media/
    anywhere,
};

} // namespace isomotion::scene

// What the fuzzers run, as functions that an ordinary test can call too: hostile bytes go in, and
// either a mistake is reported as one or all that follows from them holds.
#pragma once

#include <stdexcept>
#include <string_view>

namespace isomotion::fuzz {

// A property that doesn't hold.
struct Violation : std::logic_error {
    using std::logic_error::logic_error;
};

// A formula: text -> graph -> derivatives -> programs -> GLSL, and values in float, double and
// intervals, which must hold those in double.
void formula(std::string_view text);

// A scene file: TOML -> Scene -> values at some frames -> all shaders of it.
void scene(std::string_view text);

// Elements of any format: a table -> elements at some times, all of them numbers.
void table(std::string_view text);

// A sequence's manifest and a frame's record: JSON -> record -> the same JSON.
void manifest(std::string_view text);

// A timeline of topology: JSON -> record -> JSON -> the same record.
void timeline(std::string_view text);

// A picture's file: a map of light, its size as said and all of it finite, or a mistake.
void picture(std::string_view bytes);

// A command line, a word a line: what it asks for, not done; each word also as a range of frames,
// as a sequence's name and as a setting of a scene.
void command_line(std::string_view text);

// What a person claims of a topology, in JSON or TOML: claims, checked against an empty record.
void claims(std::string_view text);

} // namespace isomotion::fuzz

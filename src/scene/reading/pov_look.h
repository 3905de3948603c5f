// How an object of POV-Ray looks, as far as that is read: its colour and highlight.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "scene/reading/pov_values.h"

namespace isomotion::scene {

struct PovLook {
    std::optional<PovValue> color;
    bool is_clear = false; // all light passes: POV-Ray shows nothing of it
    double diffuse = 0.6, highlight = 0, shininess = 40;

    // What the surface reflects straight on of POV-Ray's highlight.
    double mirrored() const;
    // With what `known` says in place of the own.
    void take(const PovLook& known);
    // As one text, to compare looks.
    std::string text() const;
};

// Reads looks; knows those that the file declares.
class PovLooks {
public:
    explicit PovLooks(PovValues& values)
        : values_(&values) {}

    // Reads a part of a look, or a word that changes nothing here, if it is at one.
    bool read(PovCursor& at, PovLook& look);
    // Declares the look after "=", if there is one.
    bool declare(const std::string& name, PovCursor& at);
    void forget(const std::string& name) { declared_.erase(name); }

private:
    bool take_declared(PovCursor& at, PovLook& look);
    void read_pigment(PovCursor& at, PovLook& look);
    void read_finish(PovCursor& at, PovLook& look);

    PovValues* values_;
    std::map<std::string, PovLook> declared_;
    int depth_ = 0;
};

} // namespace isomotion::scene

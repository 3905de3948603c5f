// A scene's field as truth uses it: over boxes, at one frame after the other.
#pragma once

#include <memory>
#include <optional>

#include "elements/field_by_place.h"
#include "formula/enclosure.h"
#include "roots/first_root.h"
#include "scene/scene.h"
#include "scene/scene_at.h"

namespace isomotion::roots {

class EnclosedField {
public:
    // The field must outlive this object.
    explicit EnclosedField(const formula::Field& field)
        : field_(field) {}

    // The values of one frame, for root finders on all threads.
    class Frame {
    public:
        RootFinder finder(Budget budget = {}) const;

    private:
        friend class EnclosedField;
        Frame(const formula::EnclosurePrograms& programs, const scene::SurfaceAt& now)
            : programs_(programs)
            , now_(now) {}

        const formula::EnclosurePrograms& programs_;
        const scene::SurfaceAt& now_;
        std::optional<elements::FieldByPlace::Frame> by_place_; // if there are many elements
    };
    // `now` and this object must outlive the frame. `made`: an existing grid of the scene's
    // elements at that time over region_of_elements(); null to make one.
    Frame at(const scene::SurfaceAt& now, int threads,
             std::shared_ptr<const elements::ElementGrid> made = nullptr);

private:
    const formula::Field& field_;
    std::optional<elements::FieldByPlace> by_place_; // set by the first frame with many elements
    bool was_looked_for_ = false;
};

} // namespace isomotion::roots

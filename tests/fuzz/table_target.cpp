#include <cmath>

#include "base/file.h"
#include "base/printable.h"
#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "scene/error.h"
#include "scene/reading/element_table.h"

namespace isomotion::fuzz {
namespace {

constexpr int most = 50; // elements at one time

void check(const formula::ArrayColumns<double>& elements, std::size_t fields) {
    if (elements.count < 0 || elements.count > most) throw Violation("more elements than allowed");
    if (elements.fields.size() != fields) throw Violation("columns that no field has");
    for (const std::vector<double>& column : elements.fields) {
        if (column.size() != std::size_t(elements.count)) throw Violation("a column too short");
        for (const double value : column) {
            if (!std::isfinite(value)) throw Violation("a value that is no number");
        }
    }
}

} // namespace

void table(std::string_view text) {
    static const ScratchFile file("table.csv");
    scene::TableOptions options;
    options.file = file.holding(text);
    options.most = most;
    animation::Timeline timeline;
    timeline.frames = 10;
    using enum animation::ElementSamples::Interpolation;
    for (const auto interpolation : {linear, hold}) {
        options.interpolation = interpolation;
        scene::TableBudget budget{1 << 16, 1e5};
        try {
            const scene::ElementTable table = read_element_table(options, timeline, budget);
            const animation::ElementSamples& samples = *table.samples;
            const double first = samples.first_time(), last = samples.last_time();
            for (const double part : {-0.1, 0.0, 0.3, 0.5, 1.0, 1.1})
                check(samples.at(first + part * (last - first)), table.fields.size());
            for (const double time : samples.times()) {
                check(samples.at(time), table.fields.size());
                check(samples.span(time).end, table.fields.size());
            }
        } catch (const scene::SceneError& error) {
            if (base::printable(error.what()) != error.what())
                throw Violation("a message that commands a terminal");
        }
    }
}

} // namespace isomotion::fuzz

#include <cmath>

#include "base/file.h"
#include "base/printable.h"
#include "fuzz/scratch_file.h"
#include "fuzz/targets.h"
#include "scene/error.h"
#include "scene/particles/read_particles.h"
#include "scene/reading/element_table.h"

namespace isomotion::fuzz {
namespace {

constexpr int most = 50; // elements at one time

void check(const formula::ArrayColumns<double>& elements, std::size_t fields) {
    if (elements.count < 0 || elements.count > most) throw Violation("more elements than allowed");
    // Velocities may be there that no field reads.
    if (elements.fields.size() < fields) throw Violation("a field without a column");
    for (const std::vector<double>& column : elements.fields) {
        if (column.size() != std::size_t(elements.count)) throw Violation("a column too short");
        for (const double value : column) {
            if (!std::isfinite(value)) throw Violation("a value that is no number");
        }
    }
}

// All columns, under a name that tells the other kinds of text; and how many the beginning says.
void as_particles(std::string_view bytes) {
    scene::ParticleRequest request;
    request.file = "table.xyz";
    request.choose = [](const std::string&, const std::vector<std::string>& names) {
        return scene::Wanted{std::vector<bool>(names.size(), true), most, 1e5};
    };
    try {
        scene::ParticleTable table =
            scene::read_particles(request, std::string(bytes), 1 << 16).table;
        for (std::size_t k = 0; k < table.columns.size(); ++k) {
            const auto numbers = scene::take_numbers(table, request.file, k);
            if (numbers.size() != table.count) throw Violation("a column too short");
            for (const double value : numbers) {
                if (!std::isfinite(value)) throw Violation("a value that is no number");
            }
        }
    } catch (const scene::SceneError& error) {
        if (base::printable(error.what()) != error.what())
            throw Violation("a message that commands a terminal");
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
    as_particles(text);
    for (const auto interpolation : {linear, hold, hermite}) {
        options.interpolation = interpolation;
        scene::TableBudget budget{1 << 16, 1e5};
        try {
            const scene::ElementTable table =
                scene::read_element_tables(std::span(&options, 1), timeline, budget).front();
            const animation::ElementSamples& samples = *table.samples;
            const double first = samples.first_time(), last = samples.last_time();
            for (const double part : {-0.1, 0.0, 0.3, 0.5, 1.0, 1.1})
                check(samples.at(first + part * (last - first)), table.fields.size());
            for (const double time : samples.times()) {
                check(samples.at(time), table.fields.size());
                check(samples.span(time).begin, table.fields.size());
            }
        } catch (const scene::SceneError& error) {
            if (base::printable(error.what()) != error.what())
                throw Violation("a message that commands a terminal");
        }
    }
}

} // namespace isomotion::fuzz

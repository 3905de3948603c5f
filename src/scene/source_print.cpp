#include "scene/source_print.h"

#include "scene/renamed_keys.h"

namespace isomotion::scene {
namespace {

void add_number(base::Fingerprint& print, double value) {
    print.add_values(std::span<const double>(&value, 1));
}

void add_source(base::Fingerprint& print, const animation::TrackSource& source) {
    print.add(std::to_string(source.index()));
    if (const auto* number = std::get_if<double>(&source)) add_number(print, *number);
    if (const auto* expression = std::get_if<animation::Expression>(&source)) {
        print.add(expression->text);
    }
    if (const auto* keys = std::get_if<animation::Keys>(&source)) {
        add_number(print, double(keys->ease));
        for (const auto& key : keys->keys) {
            add_number(print, key.time);
            add_number(print, key.value);
        }
    }
}

} // namespace

void add(base::Fingerprint& print, const animation::Track& track) {
    print.add(first_name(track.name));
    add_source(print, track.source);
}

void add_array(base::Fingerprint& print, const animation::Animation& animation, std::size_t index) {
    const animation::Array& array = animation.arrays()[index];
    print.add(array.name);
    add_number(print, double(array.count));
    for (std::size_t f = 0; f < array.fields.size(); ++f) {
        const animation::ArrayField& field = array.fields[f];
        print.add(field.name).add(std::to_string(field.source.index()));
        if (const auto* number = std::get_if<double>(&field.source)) add_number(print, *number);
        if (const auto* expression = std::get_if<animation::Expression>(&field.source)) {
            print.add(expression->text);
        }
        if (const auto* list = std::get_if<std::vector<double>>(&field.source)) {
            print.add_values(std::span(*list));
        }
        const auto* column = std::get_if<animation::Column>(&field.source);
        // Tables may have many other columns, and be long.
        if (column && (field.is_read || animation.is_referenced(index, f)))
            array.samples->add_column(print, column->index);
    }
    if (array.samples) array.samples->add_rows(print);
}

} // namespace isomotion::scene

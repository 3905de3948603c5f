// Everything in a scene that moves: named tracks and arrays of them, as pure functions of time.
//
// A track is a number, an expression in t (which may name other tracks) or keys. An array has
// `count` elements with fields. A field is an expression in t, the element's index i and the number
// of elements n, a list of numbers, or a column of samples. It may name tracks and fields of the
// same array.
#pragma once

#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <variant>
#include <vector>

#include <isomotion/error.h>

#include "animation/element_samples.h"
#include "animation/keys.h"
#include "formula/evaluate/evaluate.h"
#include "formula/graph/names.h"
#include "formula/graph/vocabulary.h"

namespace isomotion::animation {

struct Expression {
    std::string text;
};

using TrackSource = std::variant<double, Expression, Keys>;

struct Track {
    std::string name; // "m", "camera.fov"; only identifiers can be referred to
    TrackSource source;
};

// A column of the array's samples.
struct Column {
    std::size_t index = 0;
};

using FieldSource = std::variant<double, Expression, std::vector<double>, Column>;

struct ArrayField {
    std::string name;
    FieldSource source;
    bool is_read = true; // a field has no values if neither the scene nor another field that has
                         // values reads it
};

struct Array {
    std::string name;
    int count = 0; // with samples the largest count; the samples give the count at each time
    std::vector<ArrayField> fields;
    std::shared_ptr<const ElementSamples> samples{}; // null unless some field is a Column
    bool is_of_formula = false; // terms that a formula repeats: nobody names them
};

// The values of all tracks and arrays at one time.
struct Values {
    double time = 0;
    std::vector<double> tracks; // in the order the tracks were given
    // Fields in the order in which they were given.
    std::vector<formula::ArrayColumns<double>> arrays;

    bool operator==(const Values& other) const;
};

// An error in the expression of a track or an array field; `owner` is its name ("m", "blobs.cx").
class ExpressionError : public Error {
public:
    ExpressionError(std::string owner, const std::string& message)
        : Error(Code::formula, message)
        , owner_(std::move(owner)) {}
    const std::string& owner() const { return owner_; }

private:
    std::string owner_;
};

class Animation {
public:
    Animation() = default;
    // Throws ExpressionError for bad expressions and for tracks that depend on themselves.
    Animation(std::vector<Track> tracks, std::vector<Array> arrays, std::uint64_t seed = 0);

    // Declares which fields (indices, for each array) are read.
    void keep_fields(const std::vector<std::vector<int>>& read);

    Values at(double time) const;

    const std::vector<Track>& tracks() const { return tracks_; }
    const std::vector<Array>& arrays() const { return arrays_; }
    std::vector<int> counts() const;             // elements of each array
    std::uint64_t seed() const { return seed_; } // of random(i, k)
    // The number of tracks, from the first on, whose names expressions may use.
    std::size_t nameable() const { return nameable_; }
    std::optional<int> find(std::string_view track) const;
    // True if some expression names this track.
    bool is_referenced(int track) const { return referenced_[std::size_t(track)]; }
    // True if the expression of another field of the array names this field.
    bool is_referenced(std::size_t array, std::size_t field) const {
        return compiled_arrays_[array].referenced[field];
    }

    // The instructions of a track or a field that is an expression, otherwise null. Input 0 is t;
    // for fields input 1 is i and input 2 is n. Parameter k is track k; for fields, parameters from
    // nameable() on are fields of the same array.
    const formula::Program* program(int track) const;
    const formula::Program* program(std::size_t array, std::size_t field) const;

    // Operations to evaluate all tracks at one time.
    double operations() const;
    // Operations to evaluate an array at one time, and the number of its values, for all elements.
    double operations(std::size_t array) const;
    double values(std::size_t array) const;

private:
    struct Compiled {
        formula::Program program;
        // Tracks (and fields of the same array, counted after the tracks).
        std::vector<int> references;
    };
    struct CompiledArray {
        std::vector<std::optional<Compiled>> fields;
        std::vector<int> order;       // fields with values, in order of evaluation
        std::vector<bool> referenced; // by other fields of the array
    };

    Compiled compile(const std::string& owner, const std::string& text,
                     const formula::Names& names) const;
    // The names that expressions may use, in the order of the tracks.
    std::vector<std::string> track_names() const;
    void compile_tracks();
    void compile_array(const Array& array);
    void leave_out_unread(const Array& array, CompiledArray& compiled) const;
    static void leave_out_columns(Array& array, const CompiledArray& compiled);
    formula::ArrayColumns<double> columns(std::size_t array, const Values& values) const;

    std::vector<Track> tracks_;
    std::vector<Array> arrays_;
    std::uint64_t seed_ = 0;
    // Tracks from this one on ("camera.fov") have names that expressions cannot use.
    std::size_t nameable_ = 0;
    std::vector<std::optional<Compiled>> compiled_; // for tracks that are expressions
    std::vector<CompiledArray> compiled_arrays_;
    std::vector<int> order_; // tracks in order of evaluation, referenced ones first
    std::vector<bool> referenced_;
};

// Whether all elements share the field's value: its source is a number, or an expression that names
// neither i nor n nor another field of the array.
bool stands_alone(const Array& array, std::size_t field);

} // namespace isomotion::animation

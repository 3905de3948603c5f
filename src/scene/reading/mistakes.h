// The mistakes of a scene's document. Reading tells each where it meets it, and goes on with
// something right in its place.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include <toml++/toml.h>

#include "scene/error.h"

namespace isomotion::scene {

// A mistake with its place in the document.
class PlacedError : public SceneError {
public:
    PlacedError(const toml::node& at, const std::string& message);

    unsigned line() const { return line_; } // 0 for a value of --set
    // Whether the wrong value, or what a table lacks, may name parameters, which then only seem to
    // be used by nothing.
    bool may_name_others() const { return may_name_others_; }

private:
    unsigned line_;
    bool may_name_others_;
};

struct ToldMistake {
    unsigned line = 0; // of the document, counted from 1; 0 for mistakes of --set
    std::string message;

    bool operator==(const ToldMistake&) const = default;
};

// Several mistakes. The message has one per line, ordered by line of the document.
class Mistakes : public SceneError {
public:
    explicit Mistakes(std::vector<ToldMistake> told);
    const std::vector<ToldMistake>& told() const { return told_; }

private:
    std::vector<ToldMistake> told_;
};

// Both lists, with common entries once.
Mistakes joined(const Mistakes& a, const Mistakes& b);

// Collects up to twenty mistakes.
class MistakeList {
public:
    void tell(const PlacedError& mistake);
    // Calls read() and tells the PlacedError that it throws. Returns whether it threw none.
    template<class Read> bool attempt(Read&& read) {
        try {
            read();
            return true;
        } catch (const PlacedError& mistake) {
            tell(mistake);
            return false;
        }
    }

    bool empty() const { return told_.empty(); }
    std::size_t size() const { return told_.size(); }
    bool is_full() const;
    bool may_name_others() const { return may_name_others_; }
    std::optional<Mistakes> all() const; // none if there are none
    // Throws Mistakes if there are any.
    void throw_if_any() const;

private:
    std::vector<ToldMistake> told_;
    bool may_name_others_ = false;
};

} // namespace isomotion::scene

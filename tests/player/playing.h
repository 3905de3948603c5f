// isomotion play on a display of its own, and what it tells of itself with --log.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "cli/program.h"
#include "display.h"

namespace isomotion::player {

using Json = nlohmann::json;

class Playing : public testing::Test {
protected:
    void SetUp() override;
    void TearDown() override;

    std::filesystem::path operator/(const std::string& name) const { return folder_ / name; }
    void write(const std::string& name, const std::string& text) const;

    // Starts the player; it keeps its state in the test's folder.
    void play(std::vector<std::string> words,
              const std::vector<std::pair<std::string, std::string>>& environment = {});
    // Ends it by its key, and expects that it ends well.
    void quit();
    // Waits for its end.
    cli::Ending ending();
    // What `isomotion` does with these words, in the test's folder.
    cli::Ending run(std::vector<std::string> words) const;

    // Lines of the log so far.
    const std::vector<Json>& log();
    // The first line after the mark for which this holds; waits for it, and fails without.
    Json await(const std::string& what, const std::function<bool(const Json&)>& holds);
    // A picture at rest of which this holds.
    Json await_rest(const std::string& what, const std::function<bool(const Json&)>& holds = {});
    // Lines from here on count.
    void mark() { mark_ = log().size(); }

    void key(const std::string& name) const;
    // The middle of a widget, or the place at `across` of its width.
    std::array<int, 2> place_of(const std::string& widget, double across = 0.5);
    void click(std::array<int, 2> at) const;
    void drag(std::array<int, 2> from, std::array<int, 2> to) const;

    // The picture on the screen, as a line of the log tells where it is.
    std::vector<std::array<std::uint8_t, 3>> picture(const Json& line) const;
    // Waits until the screen has what the predicate wants.
    bool screen_comes_to(const std::function<bool()>& holds) const;

    double cpu_seconds() const; // that the player has used
    Display& display() { return *display_; }

private:
    image::TemporaryFolder folder_;
    std::unique_ptr<Display> display_;
    pid_t player_ = -1;
    std::vector<Json> log_;
    std::streamoff read_ = 0; // bytes of its file
    std::size_t mark_ = 0;
};

// 64 frames of a sphere, or another formula, that grows from a dot; aspect 1.
std::string growing_sphere(const std::string& formula = "x^2 + y^2 + z^2 - r^2");

} // namespace isomotion::player

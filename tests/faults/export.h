// Exports of a short sequence into a folder, ended or disturbed at some moment.
#pragma once

#include <functional>
#include <string>

#include <fmt/format.h>

#include "cli/cli.h"

namespace isomotion::faults {

using namespace isomotion::cli;
namespace fs = std::filesystem;

inline constexpr int frames = 60;

class Export : public Cli {
protected:
    static Words command(const std::string& output, Words more = {}) {
        more.insert(more.begin(), {"render", "sphere.toml", "-o", output + "/a.####.png"});
        return more;
    }
    // The frames in the folder that have their names.
    int finished(const std::string& output) const {
        int count = 0;
        std::error_code error;
        for (fs::directory_iterator it(*this / output, error), end; it != end;
             it.increment(error)) {
            const std::string name = it->path().filename().string();
            count += name.ends_with(".png") && name[0] != '.';
        }
        return count;
    }
    using Moment = std::function<bool(std::chrono::milliseconds)>;
    Ending run_until(const Words& words, int signal, Moment moment) const {
        Circumstances circumstances = this->circumstances();
        circumstances.interrupt_when = std::move(moment);
        circumstances.interrupt_signal = signal;
        return run(words, circumstances);
    }
    // At the moment when so many frames are finished, something is done to the run.
    Ending run_with(const Words& words, const std::string& output, int count,
                    const std::function<void()>& mischief) const {
        return run_until(words, 0, [&, done = false](auto) mutable {
            if (!done && finished(output) >= count) {
                mischief();
                done = true;
            }
            return false;
        });
    }
    // An undisturbed run's frames, to hold others against.
    const std::string& whole() {
        if (!fs::exists(*this / whole_)) {
            const Ending ending = run(command(whole_));
            EXPECT_EQ(ending.code, 0) << ending;
        }
        return whole_;
    }
    void expect_frames_of(const std::string& output, bool all = true) {
        for (const std::string& name : names(whole())) {
            if (!name.ends_with(".png")) continue;
            if (!all && !fs::exists(*this / (output + "/" + name))) continue;
            EXPECT_EQ(bytes(output + "/" + name), bytes(whole() + "/" + name)) << name;
        }
    }
    void expect_verified(const std::string& output) const {
        const Ending ending = run({"verify", output, "--pixels"});
        EXPECT_EQ(ending.code, 0) << ending;
        EXPECT_THAT(ending.out, HasSubstr("\n  whole\n"));
    }

private:
    std::string whole_ = "undisturbed";
};

} // namespace isomotion::faults

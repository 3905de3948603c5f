// The class of all that isomotion throws, but std::bad_alloc.
#pragma once

#include <stdexcept>
#include <string>

namespace isomotion {

class Error : public std::runtime_error {
public:
    enum class Code {
        input,    // a scene or an argument: "file:line: key: what is wrong"
        setting,  // a member of a struct of settings, whose name comes first: "frames: what is
                  // wrong"
        formula,  // text of a Formula, with a caret below the mistake
        device,   // no OpenGL, no more threads, or the driver cannot do what it is asked
        file,     // the file system refuses, or a file is not what isomotion wrote
        stopped,  // a callback asked for it
        limit,    // too long, too large, or not decided within the limits
        internal, // a fault of this library: please report it
    };
    Error(Code code, const std::string& message)
        : std::runtime_error(message)
        , code_(code) {}
    Code code() const noexcept { return code_; }

private:
    Code code_;
};

} // namespace isomotion

// The code of the Error that a call throws.
#pragma once

#include <optional>
#include <ostream>
#include <string>

#include <gtest/gtest.h>
#include <isomotion/isomotion.h>

namespace isomotion {

struct Told {
    std::optional<Error::Code> code; // none: nothing was thrown
    std::string words;
};

template<class Call> Told told(Call&& call) {
    try {
        call();
        return {};
    } catch (const Error& error) {
        return {error.code(), error.what()};
    }
}

} // namespace isomotion

// What is derived of a field when it is first asked for (enclosure.h), and kept for all its copies.
#pragma once

#include <mutex>
#include <optional>

#include "formula/enclosure.h"

namespace isomotion::formula {

struct KeptEnclosures {
    // Derives a value once, whichever thread asks first.
    template<class T> class Once {
    public:
        template<class Derive> const T& get(const Derive& derive) {
            std::call_once(flag_, [&] { value_ = derive(); });
            return value_;
        }

    private:
        std::once_flag flag_;
        T value_;
    };

    Once<EnclosurePrograms> programs;
    Once<Program> value;
    Once<std::optional<Program>> hessian;
};

} // namespace isomotion::formula

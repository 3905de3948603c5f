#include "thorough.h"

#include <cstdlib>
#include <string_view>

namespace isomotion {

bool is_thorough() {
    const char* told = std::getenv("ISOMOTION_THOROUGH");
    return told != nullptr && std::string_view(told) == "1";
}

} // namespace isomotion

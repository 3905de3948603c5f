// Prints the findings of `isomotion doctor` for a terminal.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace isomotion::app {

// `report`: machine_report() with the back ends in "backends".
std::string doctor_table(const nlohmann::ordered_json& report);

} // namespace isomotion::app

#include <algorithm>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "app/backend_probe.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/doctor_table.h"
#include "app/machine_report.h"
#include "app/speed_probe.h"

namespace isomotion::app {
namespace {

struct DoctorArguments {
    bool json = false;
    int timeout = 120;
    std::string probed, timed; // a back end: what a child process looks at for its parent
};

// Text of drivers may be no UTF-8.
std::string dumped(const nlohmann::ordered_json& value, int indent) {
    return value.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

int doctor(const DoctorArguments& arguments) {
    if (!arguments.probed.empty()) {
        print_result("\n{}\n", dumped(probe_here(gpu::parse_backend(arguments.probed)), -1));
        return exit_done;
    }
    if (!arguments.timed.empty()) {
        print_result("\n{}\n", dumped(measure_speed_here(gpu::parse_backend(arguments.timed)), -1));
        return exit_done;
    }
    const auto found = probe_apart({gpu::Backend::egl, gpu::Backend::osmesa, gpu::Backend::glfw},
                                   std::chrono::seconds(arguments.timeout));
    nlohmann::ordered_json report = {{"version", ISOMOTION_VERSION}};
    report.update(machine_report());
    report["backends"] = found;
    const auto works = [](const auto& back_end) { return back_end["works"].template get<bool>(); };
    const auto first = std::ranges::find_if(found, works);
    if (first != found.end()) { // alone: each of several at once would take longer
        report["speed"] =
            measure_speed_apart(gpu::parse_backend((*first)["name"].get<std::string>()),
                                std::chrono::seconds(arguments.timeout));
        report["speed"]["software"] = first->value("software", true);
    }
    if (arguments.json) {
        print_result("{}\n", dumped(report, 2));
    } else {
        print_result("{}", doctor_table(report));
    }
    return first != found.end() ? exit_done : exit_machine;
}

} // namespace

void add_doctor(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<DoctorArguments>();
    CLI::App* command = app.add_subcommand(
        "doctor",
        "check which OpenGL back ends work here, measure their arithmetic, and say what to expect");
    command->add_flag("--json", arguments->json, "print JSON");
    command
        ->add_option("--timeout", arguments->timeout,
                     "seconds after which a back end counts as hanging (default: 120)")
        ->check(CLI::Range(1, 86'400));
    command->add_option("--probe", arguments->probed)->group("");
    command->add_option("--speed", arguments->timed)->group("");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return doctor(*arguments); }; });
}

} // namespace isomotion::app

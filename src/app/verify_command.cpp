#include <algorithm>
#include <filesystem>
#include <memory>
#include <numeric>
#include <optional>
#include <system_error>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "animation/frame_range.h"
#include "app/commands.h"
#include "app/console.h"
#include "app/progress.h"
#include "base/file.h"
#include "base/printable.h"
#include "sequence/manifest.h"
#include "sequence/names/sequence_name.h"
#include "sequence/verification.h"

namespace isomotion::app {
namespace fs = std::filesystem;
namespace {

struct VerifyArguments {
    std::string what;
    bool pixels = false, json = false, quiet = false;
};

bool is_manifest(const fs::path& folder) {
    return fs::is_directory(folder) && fs::exists(sequence::sequence_file(folder));
}

// Whether a folder has what is left of a manifest that lost what its frames are: reading it fails,
// and so it should.
bool was_manifest(const fs::path& folder) {
    if (!fs::is_directory(folder)) return false;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        const std::string name = entry.path().filename().string();
        const bool is_record = name.size() > 8 && name.ends_with(".json") &&
                               std::ranges::all_of(name.substr(0, name.size() - 5),
                                                   [](char c) { return '0' <= c && c <= '9'; });
        if (name == "writers" || is_record) return true;
    }
    return false;
}

std::vector<fs::path> manifests_in(const fs::path& folder) {
    std::vector<fs::path> found;
    std::error_code error;
    for (const auto& entry : fs::directory_iterator(folder, error)) {
        if (entry.path().extension() == ".manifest" &&
            (is_manifest(entry.path()) || was_manifest(entry.path()))) {
            found.push_back(entry.path());
        }
    }
    if (error) throw base::FileError(folder, "cannot be read", error.value());
    std::ranges::sort(found);
    return found;
}

// `what` is a sequence's name as `render -o` takes it, a manifest, or a folder with sequences.
std::vector<fs::path> manifests_of(const std::string& what) {
    fs::path path(what);
    while (path.has_parent_path() && (!path.has_filename() || path.filename() == ".")) {
        path = path.parent_path(); // of "out/" and "out/."; "/" is its own
        if (path == path.parent_path()) break;
    }
    if (is_manifest(path)) return {path};
    if (fs::is_directory(path)) {
        auto found = manifests_in(path);
        if (!found.empty()) return found;
        throw base::FileError(path, "has no sequence with a manifest, as render writes them");
    }
    const auto name = sequence::SequenceName::parse(what);
    if (name.holds_many()) {
        const fs::path manifest = sequence::manifest_folder(name);
        const std::string files = sequence::read_sequence(manifest).format.pattern;
        if (files != name.pattern()) throw base::FileError(manifest, "is the manifest of " + files);
        return {manifest};
    }
    if (fs::path stem = path; is_manifest(stem += ".manifest")) return {stem};
    throw base::FileError(path, "is neither a folder nor a sequence's name, as out/name.####.png");
}

void tell(const sequence::Verification& found) {
    const sequence::Sequence& sequence = found.sequence;
    const std::size_t asked = sequence.asked.size();
    print_result(
        "{}: {}, {} frame{}, {}x{}, {}\n",
        base::printable_line((found.manifest.parent_path() / sequence.format.pattern).string()),
        sequence.title, asked, asked == 1 ? "" : "s", sequence.format.width, sequence.format.height,
        sequence.provenance.renderer);
    const auto list = [](const std::string& what, const std::vector<int>& frames) {
        if (frames.empty()) return;
        print_result("  {}: {} ({})\n", what, frames.size(), animation::frame_range(frames));
    };
    if (sequence.provenance.version != ISOMOTION_VERSION) {
        print_result(
            "  made by isomotion {}: --resume by {} draws its frames again, as versions may "
            "differ in pixels\n",
            sequence.provenance.version, ISOMOTION_VERSION);
    }
    if (sequence.asked.empty()) print_result("  the manifest says that no frame was asked for\n");
    list("missing", found.missing);
    list("truncated or changed", found.changed);
    list("of an earlier scene or from elsewhere, without a record", found.unrecorded);
    list("other pixels than recorded", found.repainted);
    for (const auto& [what, frames] : found.differing) {
        list(what == "scene" ? "of another scene, or with other settings"
                             : "made by another " + what,
             frames);
    }
    list("of an earlier scene or from elsewhere, never asked for", found.foreign);
    if (!found.whole.empty()) {
        print_result("  rays:");
        for (std::size_t v = 0; v < found.verdicts.size(); ++v) {
            print_result("{} {} {}", v == 0 ? "" : ",", found.verdicts[v],
                         render::verdict_names[v]);
        }
        print_result("; {} evaluations; {:.2f} s of drawing\n", found.evaluations, found.drawing);
    }
    if (found.without_colour > 0) {
        print_result("  {} pixels whose colour is infinite or no number\n", found.without_colour);
    }
    if (std::accumulate(found.proofs.begin(), found.proofs.end(), std::int64_t(0)) > 0) {
        print_result("  {}\n", render::summary(found.proofs));
    }
    if (found.audited > 0)
        print_result("  {}\n", audit::words(sequence::findings(found.audit), found.audited));
    print_result("  {}\n", found.is_whole() ? "whole" : "not whole");
}

int verify(const VerifyArguments& arguments) {
    std::vector<sequence::Verification> all;
    for (const fs::path& manifest : manifests_of(arguments.what)) {
        std::optional<Progress> progress;
        const auto show = [&](int done, int of) {
            if (!progress) progress.emplace("verifying", of, arguments.quiet || arguments.json);
            progress->show(done);
        };
        all.push_back(sequence::verify(manifest, {.pixels = arguments.pixels, .progress = show}));
    }
    if (arguments.json) {
        print_result("{}", sequence::to_json(all));
    } else if (!arguments.quiet) {
        for (const auto& found : all) tell(found);
    }
    const bool whole = std::ranges::all_of(all, &sequence::Verification::is_whole);
    return whole ? exit_done : exit_check_failed;
}

} // namespace

void add_verify(CLI::App& app, Action& chosen) {
    const auto arguments = std::make_shared<VerifyArguments>();
    VerifyArguments& a = *arguments;
    CLI::App* command = app.add_subcommand(
        "verify", "check that rendered frames are all there, as they were written");
    command
        ->add_option("sequence", a.what,
                     "a sequence's name (out/name.####.png), or a folder with sequences")
        ->required();
    command->add_flag("--pixels", a.pixels, "decode the pictures and check their pixels, too");
    command->add_flag("--json", a.json, "print what was found as JSON");
    command->add_flag("--quiet", a.quiet, "print nothing; the exit code tells");
    command->callback(
        [arguments, &chosen] { chosen = [arguments] { return verify(*arguments); }; });
}

} // namespace isomotion::app

#include "farm/slurm.h"

#include <array>
#include <charconv>
#include <cstdio>
#include <memory>

#include <sys/wait.h>

#include <fmt/format.h>
#include <isomotion/error.h>

#include "animation/frame_range.h"
#include "base/child_process.h"
#include "farm/shell.h"

namespace isomotion::farm {
namespace {

using Words = std::vector<std::string>;

// In a line that sbatch reads nothing is quoted in the shell's way.
std::string job_name(const std::filesystem::path& script) {
    std::string name = script.stem().stem().string();
    for (char& c : name) {
        const bool safe = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                          (c >= '0' && c <= '9') || c == '-' || c == '.';
        if (!safe) c = '_';
    }
    return name;
}

struct Output {
    std::string text;
    int status = -1;
};

// What a command of the shell writes; its messages go where this program's go.
Output output_of(const std::string& command) {
    std::FILE* pipe = ::popen(command.c_str(), "re");
    if (!pipe) return {};
    Output output;
    std::array<char, 4096> piece;
    for (std::size_t n = 0; (n = std::fread(piece.data(), 1, piece.size(), pipe)) > 0;) {
        output.text.append(piece.data(), n);
    }
    const int status = ::pclose(pipe);
    if (status != -1 && WIFEXITED(status)) output.status = WEXITSTATUS(status);
    return output;
}

} // namespace

std::string slurm_script(const Job& job, std::span<const Chunk> chunks, const std::string& frames,
                         const Slurm& slurm) {
    const std::filesystem::path logs = std::filesystem::path(slurm.script).replace_extension();
    const std::string given(1, '\0'); // by the task; no word of a command can be that
    const Words words = chunk_words(job, given);
    const Words last = joining_words(job, frames);
    Words all = last;
    all.insert(all.end(), {job.folder.string(), logs.string()});

    std::string lines;
    for (std::size_t k = 0; k < chunks.size(); ++k) {
        lines += fmt::format("{}) frames={} ;;\n", k + 1, animation::frame_range(chunks[k]));
    }
    std::string render;
    for (const std::string& word : words) {
        if (!render.empty()) render += ' ';
        render += word == given ? "\"$frames\"" : shell_word(word);
    }
    std::string join;
    for (const std::string& word : last) join += ' ' + shell_word(word);

    return fmt::format(R"sh(#!/bin/sh
#SBATCH --job-name={name}
#SBATCH --requeue
#SBATCH --cpus-per-task=1
#SBATCH --output=/dev/null
# A task of the array renders a chunk of the sequence. The job without an array, after it, renders
# what is missing and joins the movie if there is to be one. What is whole is kept, so that both may
# be submitted again at any time:
#
#     sbatch --array=1-{chunks} {script}
#     sbatch --dependency=afterok:JOB {script}

{newline}logs={logs}
mkdir -p "$logs"
exec >>"$logs/${{SLURM_ARRAY_TASK_ID:-join}}.log" 2>&1
cd {folder} || exit 3
export LP_NUM_THREADS="${{SLURM_CPUS_PER_TASK:-1}}" # threads of Mesa's software renderer

case ${{SLURM_ARRAY_TASK_ID:-join}} in
{lines}join) exec{join} ;;
*) echo "there is no chunk $SLURM_ARRAY_TASK_ID"; exit 2 ;;
esac

{render}
code=$?
# A chunk that fails is tried again, perhaps on another machine, but not if the scene is wrong.
if [ $code -ne 0 ] && [ $code -ne 2 ] && [ "${{SLURM_RESTART_COUNT:-0}}" -lt {again} ]; then
    echo "frames $frames: exit status $code on $(hostname), tried again"
    scontrol requeue "$SLURM_JOB_ID" && sleep 600 # until Slurm ends this try
fi
exit $code
)sh",
                       fmt::arg("name", job_name(slurm.script)), fmt::arg("chunks", chunks.size()),
                       fmt::arg("script", shell_word(slurm.script.string())),
                       fmt::arg("newline", newline_definition(all)),
                       fmt::arg("folder", shell_word(job.folder.string())),
                       fmt::arg("logs", shell_word(logs.string())), fmt::arg("lines", lines),
                       fmt::arg("join", join), fmt::arg("render", render),
                       fmt::arg("again", slurm.tries - 1));
}

Words sbatch_array(const Slurm& slurm, std::size_t chunks) {
    std::string array = fmt::format("--array=1-{}", chunks);
    if (slurm.workers > 0) array += fmt::format("%{}", slurm.workers);
    Words words{"sbatch", "--parsable"};
    words.insert(words.end(), slurm.options.begin(), slurm.options.end());
    words.insert(words.end(), {array, slurm.script.string()});
    return words;
}

Words sbatch_joining(const Slurm& slurm, const std::string& array) {
    Words words{"sbatch", "--parsable"};
    words.insert(words.end(), slurm.options.begin(), slurm.options.end());
    // Without the second it would wait for ever behind an array with a chunk that was given up.
    words.insert(words.end(), {"--dependency=afterok:" + array, "--kill-on-invalid-dep=yes",
                               slurm.script.string()});
    return words;
}

std::size_t largest_array() {
    std::size_t size = 1001; // MaxArraySize: the largest number of a task, and one more
    if (!base::find_program("scontrol")) return size - 1;
    const std::string text = output_of("scontrol show config 2>/dev/null").text;
    constexpr std::string_view key = "MaxArraySize";
    if (const auto at = text.find(key); at != text.npos) {
        const auto digits = text.find_first_of("0123456789", at);
        if (digits != text.npos) {
            std::from_chars(text.data() + digits, text.data() + text.size(), size);
        }
    }
    return std::max<std::size_t>(size, 2) - 1;
}

std::string submit(const Words& sbatch) {
    if (!base::find_program(sbatch.front())) {
        throw Error(Error::Code::device,
                    "sbatch is not on PATH: this machine submits to no Slurm; --engine print "
                    "writes the commands for any other farm, --engine local renders here");
    }
    const Output output = output_of(command_line(sbatch));
    // "JOB" or "JOB;CLUSTER"
    std::string id = output.text.substr(0, output.text.find_first_of(";\n"));
    if (output.status != 0 || id.empty()) {
        throw Error(Error::Code::device,
                    fmt::format("sbatch ended with exit status {}", output.status));
    }
    return id;
}

} // namespace isomotion::farm

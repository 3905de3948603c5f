// The script that Slurm is given, run by /bin/sh in Slurm's place.
#include "farm/slurm.h"

#include <fstream>

#include <fmt/format.h>

#include "cli.h"
#include "files.h"
#include "nasty_words.h"
#include "sequence/names/sequence_name.h"

namespace isomotion::farm {
namespace {

namespace fs = std::filesystem;
using cli::Words;
using testing::HasSubstr;

class SlurmScript : public cli::Cli {
protected:
    // In isomotion's place: its words and what it finds, each ended by a NUL.
    SlurmScript() {
        write("program",
              "#!/bin/sh\n"
              "for word in \"$@\" \"$(pwd; echo .)\" \"$LP_NUM_THREADS\" \"$EXTRA\"; do\n"
              "    printf '%s\\0' \"$word\"\n"
              "done >>\"$RECORD\"\n"
              "exit ${CODE:-0}\n");
        write("scontrol", "#!/bin/sh\necho \"$@\" >>\"$RECORD.scontrol\"\nexit 1\n");
        for (const char* name : {"program", "scontrol"}) {
            fs::permissions(*this / name, fs::perms::owner_all);
        }
    }
    cli::Ending run_task(const std::string& task, const std::string& code = "0",
                         const std::string& restarts = "0") const {
        cli::Circumstances at = circumstances();
        at.environment["RECORD"] = *this / "record";
        at.environment["CODE"] = code;
        at.environment["PATH"] = folder().string() + ":/usr/bin:/bin";
        at.environment["SLURM_JOB_ID"] = "77";
        at.environment["SLURM_CPUS_PER_TASK"] = "4";
        at.environment["SLURM_RESTART_COUNT"] = restarts;
        if (!task.empty()) at.environment["SLURM_ARRAY_TASK_ID"] = task;
        fs::remove(*this / "record");
        return cli::run({"/bin/sh", *this / "script"}, at);
    }
    std::string recorded() const { return bytes("record"); }
    static std::string as_recorded(const Words& words, const Job& job) {
        std::string text;
        for (auto word = words.begin() + std::ptrdiff_t(2 + job.environment.size());
             word != words.end(); ++word) {
            text += *word + '\0';
        }
        return text + job.folder.string() + "\n." + '\0' + "4" + '\0' +
               job.environment.front().substr(6) + '\0';
    }
};

TEST_F(SlurmScript, SaysWhatItShouldWhateverTheNames) {
    const unsigned seed = std::random_device{}();
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    std::mt19937 random(seed);
    // A folder's name has no slash, and is none of the two that every folder has.
    const auto name = [&] {
        std::string text = "x" + nasty_word(random);
        std::ranges::replace(text, '/', '_');
        return text.substr(0, 100);
    };
    for (int k = 0; k < 25; ++k) {
        Job job;
        job.program = *this / "program";
        job.folder = folder() / name();
        job.scene = "/" + name();
        job.output = job.folder / name() / (sequence::stem_of_frames(name()) + ".####.png");
        if (k % 2) job.movies = {job.folder / (name() + ".mp4")};
        job.frames = "1-3,4-8x2,9";
        job.options = {nasty_word(random), "$frames", nasty_word(random)};
        job.environment = {"EXTRA=" + nasty_word(random)};
        fs::create_directories(job.output.parent_path());
        Slurm slurm;
        slurm.script = job.output.parent_path() / (stem(job.output) + ".slurm.sh");
        const std::vector<Chunk> chunks{{1, 2, 3}, {4, 6, 8}, {9}};
        const std::string text = slurm_script(job, chunks, job.frames, slurm);
        EXPECT_EQ(text.find("\r\n"), text.npos);
        write("script", text);
        const std::string ranges[] = {"1-3", "4-8x2", "9"};
        for (std::size_t task = 0; task < 3; ++task) {
            const cli::Ending ending = run_task(std::to_string(task + 1));
            EXPECT_EQ(ending.code, 0) << ending << text;
            EXPECT_EQ(recorded(), as_recorded(chunk_words(job, ranges[task]), job)) << text;
        }
        EXPECT_EQ(run_task("").code, 0);
        EXPECT_EQ(recorded(), as_recorded(joining_words(job, job.frames), job)) << text;
        fs::path logs = slurm.script;
        logs.replace_extension();
        EXPECT_TRUE(fs::exists(logs / "2.log") && fs::exists(logs / "join.log"));
    }
}

TEST_F(SlurmScript, FailedChunksAskToBeTriedAgainAsOftenAsTheyMay) {
    Job job;
    job.program = *this / "program";
    job.folder = folder();
    job.output = *this / "a.####.png";
    const std::vector<Chunk> chunks{{1, 2, 3}};
    write("script", slurm_script(job, chunks, "1-3", {.script = *this / "a.slurm.sh", .tries = 3}));
    const auto asked = [&](const std::string& code, const std::string& restarts) {
        fs::remove(*this / "record.scontrol");
        EXPECT_EQ(std::to_string(run_task("1", code, restarts).code), code);
        return fs::exists(*this / "record.scontrol") ? bytes("record.scontrol") : "";
    };
    EXPECT_EQ(asked("3", "0"), "requeue 77\n");
    EXPECT_EQ(asked("137", "1"), "requeue 77\n");
    EXPECT_EQ(asked("3", "2"), "");
    EXPECT_EQ(asked("2", "0"), ""); // a wrong scene
    EXPECT_EQ(asked("0", "0"), "");
    EXPECT_THAT(bytes("a.slurm/1.log"), HasSubstr("frames 1-3: exit status 137 on "));
}

TEST_F(SlurmScript, IsWrittenWithoutSubmittingOnADryRun) {
    cli::Circumstances without = circumstances();
    without.environment["PATH"] = folder();
    const Words words{"submit", "sphere.toml", "--engine", "slurm",     "--frames",
                      "1-50",   "--chunk",     "20",       "--workers", "2"};
    const cli::Ending refused = run(words, without);
    EXPECT_EQ(refused.code, 3) << refused;
    EXPECT_THAT(refused.err, HasSubstr("sbatch is not on PATH"));
    EXPECT_THAT(refused.err, HasSubstr("--engine print"));

    Words dry = words;
    dry.insert(dry.end(), {"--dry-run", "--sbatch=--partition=a b"});
    const cli::Ending ending = run(dry, without);
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.out, HasSubstr("sbatch --parsable '--partition=a b' --array=1-4%2 "));
    EXPECT_THAT(ending.out, HasSubstr("--dependency=afterok:JOB"));
    EXPECT_THAT(bytes("out/sphere.slurm.sh"), HasSubstr("\n4) frames=38-50 ;;\n"));
    EXPECT_EQ(files_in(*this / "out"), std::set<std::string>{"sphere.slurm.sh"});
}

TEST_F(SlurmScript, ChunksGrowWhereAnArrayWouldBeTooLong) {
    cli::Circumstances without = circumstances();
    without.environment["PATH"] = folder(); // nobody to ask: Slurm's default holds
    const cli::Ending ending = run({"submit", "sphere.toml", "--engine", "slurm", "--dry-run",
                                    "--frames", "1-2500", "--chunk", "2"},
                                   without);
    EXPECT_EQ(ending.code, 0) << ending;
    EXPECT_THAT(ending.err, HasSubstr("arrays of 1000 tasks: chunks have 3 frames, not 2"));
    EXPECT_THAT(ending.out, HasSubstr("--array=1-1000 "));
}

TEST(Stem, IsTheSequencesName) {
    EXPECT_EQ(stem("out/name.####.png"), "name");
    EXPECT_EQ(stem("/a b/name_%04d.exr"), "name");
    EXPECT_EQ(stem("100%.##.png"), "100%");
    EXPECT_EQ(stem("####.png"), "frames");
}

} // namespace
} // namespace isomotion::farm

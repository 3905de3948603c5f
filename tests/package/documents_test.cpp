// The manual page, the shells' completions and the desktop entry say what the program does.
#include "installation.h"

#include <fstream>
#include <iterator>
#include <regex>

#include "base/child_process.h"

namespace isomotion::package {
namespace {

namespace fs = std::filesystem;
using testing::Contains;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::IsEmpty;
using testing::Not;

std::string text_of(const fs::path& file) {
    std::ifstream stream(file);
    EXPECT_TRUE(stream) << file;
    return {std::istreambuf_iterator<char>(stream), {}};
}

std::vector<std::string> found(const std::string& text, const char* pattern) {
    const std::regex regex(pattern);
    std::vector<std::string> all;
    for (std::sregex_iterator at(text.begin(), text.end(), regex), end; at != end; ++at) {
        all.push_back((*at)[1]);
    }
    return all;
}

class Documents : public Installation {
protected:
    static std::string told(std::vector<std::string> words) {
        words.insert(words.begin(), prefix() / "bin/isomotion");
        return done(words).out;
    }
    static std::vector<std::string> commands() { return found(told({"--help"}), "\n  ([a-z]+) "); }
    // "--frames", "-o": as the help of a command lists them.
    static std::vector<std::string> options(const std::string& command) {
        std::vector<std::string> all;
        for (const std::string& names : found(told({command, "--help"}), "\n  (-[-a-z,]+)[ {]")) {
            for (const std::string& name : found(names, "(-[-a-z]+)")) all.push_back(name);
        }
        return all;
    }
};

TEST_F(Documents, TellEveryCommandAndOption) {
    const std::string manual = std::regex_replace(
        done({"/bin/sh", "-c", "gzip -dc \"$0\"", share() / "man/man1/isomotion.1.gz"}).out,
        std::regex(R"(\\-)"), "-");
    const std::string bash = text_of(share() / "bash-completion/completions/isomotion");
    const std::string zsh = text_of(share() / "zsh/vendor-completions/_isomotion");
    const std::string fish = text_of(share() / "fish/vendor_completions.d/isomotion.fish");
    ASSERT_THAT(commands(), Contains("render"));
    for (const std::string& command : commands()) {
        SCOPED_TRACE(command);
        EXPECT_THAT(manual, HasSubstr(".SS " + command + "\n"));
        const auto words = found(bash, ("\n +" + command + "\\) options=\"([^\"]*)\"").c_str());
        ASSERT_EQ(words.size(), 1u);
        const std::vector<std::string> all = options(command);
        ASSERT_THAT(all, Contains("--help"));
        for (const std::string& option : all) {
            SCOPED_TRACE(option);
            EXPECT_THAT(manual, HasSubstr("\\fB" + option + "\\fR"));
            EXPECT_THAT(" " + words.front() + " ", HasSubstr(" " + option + " "));
            EXPECT_THAT(zsh, HasSubstr("*" + option + "["));
            const bool is_long = option.starts_with("--");
            EXPECT_THAT(
                fish, HasSubstr((is_long ? "-l " : "-s ") + option.substr(is_long ? 2 : 1) + " "));
        }
    }
    for (const std::string* text : {&bash, &zsh, &fish}) {
        EXPECT_THAT(*text, HasSubstr(" blobby75 "));
        EXPECT_THAT(*text, Not(ContainsRegex("[ '\"]describe[ :)]"))); // it is hidden
    }
}

// What bash offers for the last of these words.
std::string completed(const fs::path& script, const std::vector<std::string>& words) {
    std::vector<std::string> all{"/bin/bash", "-c",
                                 "source \"$0\"; COMP_WORDS=(isomotion \"$@\"); COMP_CWORD=$#; "
                                 "_isomotion; echo \"${COMPREPLY[*]}\"",
                                 script};
    all.insert(all.end(), words.begin(), words.end());
    return cli::run(all, {}).out;
}

TEST_F(Documents, BashCompletes) {
    const fs::path script = share() / "bash-completion/completions/isomotion";
    EXPECT_EQ(completed(script, {"topo"}), "topology\n");
    EXPECT_EQ(completed(script, {"render", "barth_s"}), "barth_sextic\n");
    EXPECT_EQ(completed(script, {"render", "blobby75", "--back"}), "--backend\n");
    EXPECT_EQ(completed(script, {"render", "blobby75", "--backend", "os"}), "osmesa\n");
    EXPECT_EQ(completed(script, {"list", "s"}), "surfaces\n");
    EXPECT_EQ(completed(script, {"topology", "blobby75", "--certify", "f"}), "fast full\n");
}

constexpr const char* metainfo = "metainfo/invalid.isomotion.isomotion.metainfo.xml";

// A software centre installs by the one and starts by the other.
TEST_F(Documents, MetainfoIsOfTheProgramAndItsDesktopEntry) {
    const std::string about = text_of(share() / metainfo);
    const std::string entry = text_of(share() / "applications/isomotion.desktop");
    EXPECT_THAT(metainfo, HasSubstr("/" + found(about, "<id>([^<]*)</id>").at(0) + ".metainfo"));
    for (const std::string& file : found(about, "desktop-id\">([^<]*)<")) {
        EXPECT_TRUE(fs::exists(share() / "applications" / file)) << file;
    }
    for (const std::string& program : found(about, "<binary>([^<]*)<")) {
        EXPECT_TRUE(fs::exists(prefix() / "bin" / program)) << program;
    }
    for (const std::string& icon : found(about, "<icon type=\"stock\">([^<]*)<")) {
        EXPECT_TRUE(fs::exists(share() / "icons/hicolor/scalable/apps" / (icon + ".svg"))) << icon;
    }
    EXPECT_EQ(found(about, "<(launchable|binary|icon)[ >]").size(), 3u);

    const auto together = [](const std::vector<std::string>& words) {
        std::string all;
        for (const std::string& word : words) all += word + ";";
        return all;
    };
    EXPECT_THAT(entry, HasSubstr("\nCategories=" + together(found(about, "<category>([^<]*)<"))));
    EXPECT_THAT(entry, HasSubstr("\nMimeType=" + together(found(about, "<mediatype>([^<]*)<"))));
    EXPECT_THAT(told({"--version"}),
                HasSubstr(found(about, "<release version=\"([^\"]*)\"").at(0)));
}

struct Reader {
    const char* program;
    std::vector<std::string> options;
    const char* file;
    bool says_nothing = true; // where nothing is wrong
};

// None of these is needed to build, test or run the program: each reads its file where it is
// installed.
TEST_F(Documents, AreReadByWhomTheyAreFor) {
    const Reader readers[] = {
        {"zsh", {"-n"}, "zsh/vendor-completions/_isomotion"},
        {"fish", {"-n"}, "fish/vendor_completions.d/isomotion.fish"},
        {"man", {"--warnings", "-l"}, "man/man1/isomotion.1.gz", false},
        {"desktop-file-validate", {}, "applications/isomotion.desktop"},
        {"appstreamcli", {"validate", "--no-net"}, metainfo, false},
    };
    int read = 0;
    for (const Reader& reader : readers) {
        const auto program = base::find_program(reader.program);
        if (!program) continue;
        std::vector<std::string> words{*program};
        words.insert(words.end(), reader.options.begin(), reader.options.end());
        words.push_back(share() / reader.file);
        const cli::Ending ending = done(words);
        EXPECT_THAT(ending.err, IsEmpty());
        EXPECT_THAT(reader.says_nothing ? ending.out : "", IsEmpty());
        ++read;
    }
    // A fresh machine has none of them.
    if (read == 0) GTEST_SKIP() << "no zsh, fish, man, desktop-file-validate or appstreamcli here";
}

} // namespace
} // namespace isomotion::package

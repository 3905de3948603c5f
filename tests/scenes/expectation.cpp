#include "scenes/expectation.h"

#include <algorithm>
#include <cctype>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "base/file_text.h"
#include "base/input_error.h"
#include "thorough.h"

namespace isomotion::scenes {
namespace {

using base::DocumentNode, base::DocumentTable;

// A value as it stands in a scene: texts without their quotes.
std::string word(const DocumentNode& node) {
    if (node.is_list()) {
        std::vector<std::string> words;
        for (const DocumentNode& one : node.list()) words.push_back(word(one));
        return fmt::format("[{}]", fmt::join(words, ", "));
    }
    if (!node.is_number()) {
        try {
            return node.text();
        } catch (const base::InputError&) {
            return node.boolean() ? "true" : "false";
        }
    }
    return fmt::format("{}", node.number());
}

Values values_of(DocumentTable table) {
    Values values;
    for (const DocumentNode& node : table.all()) values[table.key_of(node)] = word(node);
    return values;
}

// Reads what a test expects, with the values of its places.
class Reading {
public:
    Reading(const std::string& test, const Values& values)
        : test_(test)
        , values_(values) {}

    std::string text(const DocumentNode& node) const { return with_values(node.text(), values_); }
    // A number, or an expression of numbers.
    double number(const DocumentNode& node) const {
        return node.is_number() ? node.number() : number_of(text(node));
    }
    std::int64_t count(const DocumentNode& node) const { return std::int64_t(number(node)); }
    std::vector<std::string> texts(const std::optional<DocumentNode>& node) const {
        std::vector<std::string> all;
        if (!node) return all;
        if (!node->is_list()) return {text(*node)};
        for (const DocumentNode& one : node->list()) all.push_back(text(one));
        return all;
    }
    // Whether an expectation is of the test: it may name those of `all` that it is of.
    bool is_of_test(DocumentTable& table, const std::vector<std::string>& all) const {
        const auto named = table.find("tests");
        const std::vector<std::string> names = texts(named);
        for (const std::string& name : names)
            if (std::ranges::count(all, name) == 0) named->fail("there is no test " + name);
        return !named || std::ranges::count(names, test_) > 0;
    }

    // How a picture differs from another.
    Look look(DocumentTable table, Look look) const;
    That that(DocumentTable& table) const;
    Same same(DocumentTable& table) const;
    Truth truth(DocumentTable& table) const;
    Methods methods(DocumentTable& table) const;

private:
    const std::string& test_;
    const Values& values_;
};

Look Reading::look(DocumentTable table, Look look) const {
    if (const auto with = table.find("with"))
        for (const auto& [name, value] : values_of(with->table())) look.with[name] = value;
    if (const auto gallery = table.find("gallery")) look.gallery = text(*gallery);
    for (const std::string& setting : texts(table.find("set"))) look.set.push_back(setting);
    if (const auto channels = table.find("channels")) {
        look.channels.clear();
        for (const DocumentNode& node : channels->list()) {
            const auto channel = shader::parse_channel(text(node));
            if (!channel) node.fail("is no channel");
            look.channels.push_back(*channel);
        }
    }
    if (const auto frame = table.find("frame")) look.frame = int(count(*frame));
    if (const auto plan = table.find("plan")) {
        const std::vector<DocumentNode> sizes = plan->list(3);
        look.plan =
            render::MarchPlan{int(count(sizes[0])), int(count(sizes[1])), int(count(sizes[2]))};
    }
    if (const auto stage = table.find("stage")) look.stage = render::parse_stage(text(*stage));
    table.refuse_rest();
    return look;
}

That Reading::that(DocumentTable& table) const {
    That that;
    if (const auto let = table.find("let")) that.let = text(*let);
    that.where = texts(table.find("where"));
    that.is = texts(table.find("is"));
    that.counts = texts(table.find("counts"));
    if (const auto within = table.find("within")) that.within = number(*within);
    if (const auto but = table.find("but")) that.but = count(*but);
    if (const auto least = table.find("pixels")) that.least = count(*least);
    if (const auto most = table.find("at_most")) {
        that.most = count(*most);
        if (!table.find("pixels")) that.least = 0;
    }
    if (const auto sums = table.find("sums")) that.sums = values_of(sums->table());
    if (that.is.empty() && that.counts.empty() && !table.find("pixels") && !table.find("at_most"))
        table.at("is"); // which is missing
    table.refuse_rest();
    return that;
}

Same Reading::same(DocumentTable& table) const {
    Same same;
    same.as = text(table.at("as"));
    if (const auto of = table.find("of")) same.of = text(*of);
    same.without = texts(table.find("without"));
    if (const auto within = table.find("within")) same.within = number(*within);
    if (const auto but = table.find("but")) same.but = count(*but);
    table.refuse_rest();
    return same;
}

Truth Reading::truth(DocumentTable& table) const {
    Truth truth;
    if (const auto of = table.find("of")) truth.of = text(*of);
    if (const auto wrong = table.find("wrong")) truth.wrong = count(*wrong);
    if (const auto undecided = table.find("undecided")) truth.undecided = count(*undecided);
    table.refuse_rest();
    return truth;
}

Methods Reading::methods(DocumentTable& table) const {
    Methods methods{test_, {}, {}, true};
    if (const auto label = table.find("label")) methods.label = text(*label);
    if (const auto truth = table.find("truth_of")) methods.truth_of = values_of(truth->table());
    if (const auto any = table.find("any_size")) methods.any_size = any->boolean();
    DocumentTable wrong = table.at("wrong_ppm").table();
    for (const DocumentNode& node : wrong.all()) {
        const bool is_blind = !node.is_number() && text(node) == "blind";
        methods.wrong_ppm[wrong.key_of(node)] = is_blind ? 1e6 : number(node);
    }
    if (!methods.wrong_ppm.contains("default")) wrong.at("default");
    table.refuse_rest();
    return methods;
}

} // namespace

SceneFile::SceneFile(const std::filesystem::path& file)
    : path_(file.string()) {
    const std::string text = base::file_text(file, 1 << 20);
    std::size_t begin = text.find("\n[expect");
    begin = std::min(begin, text.find("\n[[expect"));
    if (begin == text.npos) throw base::InputError(path_ + ": expects nothing: no line [expect]");
    scene_ = text.substr(0, begin + 1);
    // Lines count from the file's first one.
    tail_ =
        std::string(std::size_t(std::ranges::count(scene_, '\n')), '\n') + text.substr(begin + 1);
    const base::Document document = base::Document::from_toml(tail_, path_);
    DocumentTable whole = document.table();
    DocumentTable expect = whole.at("expect").table();
    whole.refuse_rest();
    if (const auto backends = expect.find("every_backend")) every_backend_ = backends->boolean();
    if (const auto with = expect.find("with")) with_ = values_of(with->table());
    for (const auto& [key, list] : {std::pair{"each", &each_}, {"try", &try_}}) {
        const auto given = expect.find(key);
        if (!given) continue;
        DocumentTable tried = given->table();
        for (const DocumentNode& node : tried.all()) {
            std::vector<std::string> words;
            for (const DocumentNode& one : node.list()) words.push_back(word(one));
            if (words.empty()) node.fail("must list values");
            list->emplace_back(tried.key_of(node), words);
        }
    }
    if (const auto tests = expect.find("tests")) {
        for (const DocumentNode& node : tests->list()) {
            DocumentTable row = node.table();
            const std::string name = row.at("name").text();
            Values values = values_of(row);
            for (const auto& [other, its] : tests_)
                if (other == name) node.fail("another test has this name");
            tests_.emplace_back(name, std::move(values));
        }
    } else {
        tests_.emplace_back(file.stem().string(), Values{});
    }
}

std::vector<std::string> SceneFile::tests() const {
    std::vector<std::string> names;
    for (const auto& [name, values] : tests_) names.push_back(name);
    return names;
}

std::vector<std::pair<std::string, Expectations>>
SceneFile::expected_of(const std::string& test) const {
    Values values = with_;
    for (const auto& [name, its] : tests_)
        if (name == test)
            for (const auto& [key, value] : its) values[key] = value;
    std::vector<std::pair<std::string, Expectations>> all;
    std::size_t of_each = 1, product = 1, longest = 1;
    for (const auto& [name, words] : each_) of_each *= words.size();
    for (const auto& [name, words] : try_) {
        product *= words.size();
        longest = std::max(longest, words.size());
    }
    const std::size_t runs = is_thorough() ? of_each * product : std::max(of_each, longest);
    for (std::size_t k = 0; k < runs; ++k) {
        std::string told;
        const auto take = [&](const auto& list, std::size_t index, bool as_digits) {
            for (const auto& [name, words] : list) {
                values[name] = words[index % words.size()];
                told += fmt::format("{}{} = {}", told.empty() ? "" : ", ", name, values[name]);
                if (as_digits) index /= words.size();
            }
        };
        take(each_, k % of_each, true);
        take(try_, is_thorough() ? k / of_each : k, is_thorough());
        all.emplace_back(told, expected(test, values));
    }
    return all;
}

Expectations SceneFile::expected(const std::string& test, const Values& values) const {
    const base::Document document = base::Document::from_toml(tail_, path_);
    const Reading reading(test, values);
    DocumentTable whole = document.table();
    DocumentTable expect = whole.at("expect").table();
    for (const char* of_all : {"every_backend", "with", "each", "try", "tests"})
        expect.find(of_all);
    Expectations expected;
    Look own;
    own.with = values;
    expected.pictures[""] = own;
    if (const auto look = expect.find("look"))
        own = expected.pictures[""] = reading.look(look->table(), own);
    if (const auto pictures = expect.find("pictures")) {
        DocumentTable named = pictures->table();
        for (const DocumentNode& node : named.all())
            expected.pictures[named.key_of(node)] = reading.look(node.table(), own);
    }
    for (const char* kind : {"that", "same", "truth"}) {
        const auto list = expect.find(kind);
        if (!list) continue;
        for (const DocumentNode& node : list->list()) {
            DocumentTable table = node.table();
            if (!reading.is_of_test(table, tests())) continue;
            if (kind == std::string_view("that"))
                expected.that.push_back(reading.that(table));
            else if (kind == std::string_view("same"))
                expected.same.push_back(reading.same(table));
            else
                expected.truths.push_back(reading.truth(table));
        }
    }
    if (const auto methods = expect.find("methods")) {
        DocumentTable table = methods->table();
        if (reading.is_of_test(table, tests())) expected.methods = reading.methods(table);
    }
    if (const auto refused = expect.find("refused")) expected.refused = reading.texts(refused);
    expect.refuse_rest();
    const auto expect_picture = [&](const std::string& name) {
        if (!expected.pictures.contains(name))
            throw base::InputError(fmt::format("{}: there is no picture '{}'", path_, name));
    };
    for (const Truth& truth : expected.truths) expect_picture(truth.of);
    for (const Same& same : expected.same) {
        expect_picture(same.as);
        expect_picture(same.of);
    }
    if (expected.that.empty() && expected.same.empty() && expected.truths.empty() &&
        !expected.methods && expected.refused.empty())
        throw base::InputError(fmt::format("{}: expects nothing of the test {}", path_, test));
    return expected;
}

} // namespace isomotion::scenes

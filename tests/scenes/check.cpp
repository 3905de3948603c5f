#include "scenes/check.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <memory>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include "accuracy/compare.h"
#include "gpu/compute.h"
#include "roots/certify.h"
#include "scenes/hard_case.h"
#include "scenes/statement.h"

namespace isomotion::scenes {
namespace {

using Pictures = std::map<std::string, std::shared_ptr<const Drawn>>; // by name

std::string prefix_of(const std::string& picture) { return picture.empty() ? "" : picture + "_"; }

std::vector<Statement> compiled(const std::vector<std::string>& texts, const std::string& let,
                                const std::vector<std::string>& names) {
    std::vector<Statement> all;
    for (const std::string& text : texts) all.emplace_back(text, let, names);
    return all;
}

void check(const That& that, const Pictures& pictures) {
    std::vector<std::string> names, of_totals;
    std::vector<double> totals;
    const std::size_t pixels = pictures.at("")->picture.frame.channels[0].samples.size();
    std::vector<PixelNumbers> of_pictures;
    for (const auto& [name, drawn] : pictures) {
        const auto of_pixels = of_pictures.emplace_back(*drawn).names(prefix_of(name));
        const auto of_whole = total_names(prefix_of(name));
        names.insert(names.end(), of_pixels.begin(), of_pixels.end());
        of_totals.insert(of_totals.end(), of_whole.begin(), of_whole.end());
        if (!that.counts.empty()) add_totals(*drawn, totals);
        ASSERT_EQ(drawn->picture.frame.channels[0].samples.size(), pixels) << "in " << name;
    }
    std::vector<Statement> where = compiled(that.where, that.let, names);
    std::vector<Statement> is = compiled(that.is, that.let, names);
    std::vector<Statement> summed;
    std::vector<double> sums;
    for (const auto& [name, formula] : that.sums) {
        summed.emplace_back("0 = " + formula, that.let, names);
        sums.push_back(0);
    }
    std::int64_t checked = 0, wrong = 0;
    std::string first;
    std::vector<double> numbers;
    const bool is_of_pixels = !where.empty() || !is.empty() || !summed.empty();
    if (!is_of_pixels) checked = std::int64_t(pixels);
    for (std::size_t pixel = 0; is_of_pixels && pixel < pixels; ++pixel) {
        numbers.clear();
        for (const PixelNumbers& one : of_pictures) one.add(pixel, numbers);
        const auto is_true = [&](Statement& one) { return one.holds(numbers); };
        if (!std::ranges::all_of(where, is_true)) continue;
        ++checked;
        bool right = true;
        for (Statement& one : is) {
            if (one.holds(numbers, that.within)) continue;
            right = false;
            if (first.empty()) {
                const int width = pictures.at("")->picture.frame.width;
                first = fmt::format("{}, at column {}, row {}", one.told(), int(pixel) % width,
                                    int(pixel) / width);
            }
        }
        wrong += !right;
        for (std::size_t k = 0; k < sums.size(); ++k) {
            summed[k].holds(numbers);
            sums[k] += summed[k].right();
        }
    }
    EXPECT_LE(wrong, that.but) << "of " << checked << " pixels; first " << first;
    EXPECT_GE(checked, that.least)
        << "pixels where " << fmt::format("{}", fmt::join(that.where, ", "));
    EXPECT_LE(checked, that.most) << "pixels where "
                                  << fmt::format("{}", fmt::join(that.where, ", "));
    for (const auto& [name, formula] : that.sums) of_totals.push_back(name);
    totals.insert(totals.end(), sums.begin(), sums.end());
    for (Statement& one : compiled(that.counts, {}, of_totals))
        EXPECT_TRUE(one.holds(totals, that.within)) << one.told();
}

void check(const Same& wanted, const Pictures& pictures) {
    const Drawn &one = *pictures.at(wanted.of), &other = *pictures.at(wanted.as);
    for (const image::Channel& layer : one.picture.frame.channels) {
        const image::Channel* same = other.picture.frame.find(layer.name);
        if (!same || std::ranges::count(wanted.without, layer.name) > 0) continue;
        ASSERT_EQ(layer.samples.size(), same->samples.size());
        std::int64_t different = 0;
        std::string first;
        for (std::size_t k = 0; k < layer.samples.size(); ++k) {
            const float a = layer.samples[k], b = same->samples[k];
            if (std::memcmp(&a, &b, sizeof(float)) == 0) continue; // infinite or no numbers, too
            if (wanted.within > 0 && (a == b || std::abs(a - b) <= wanted.within)) continue;
            if (++different == 1)
                first =
                    fmt::format("{} and {} at column {}, row {}", a, b,
                                int(k) % one.picture.frame.width, int(k) / one.picture.frame.width);
        }
        EXPECT_LE(different, wanted.but)
            << layer.name << " of '" << wanted.of << "' and '" << wanted.as << "': " << first;
    }
    if (wanted.within > 0 || wanted.but > 0 || !wanted.without.empty()) return;
    EXPECT_EQ(one.picture.evaluations(), other.picture.evaluations()) << wanted.as;
    EXPECT_EQ(one.picture.verdicts, other.picture.verdicts) << wanted.as;
}

// Caps where truth has the surface, and the surface where truth has a cap.
std::int64_t other_caps(const image::Frame& drawn, const roots::Truth& truth) {
    const bool is_one = drawn.find("surface") == nullptr; // of several, truth may not know which
    const image::Channel* caps = drawn.find("cap");
    std::int64_t other = 0;
    for (std::size_t k = 0; caps && k < truth.roots.size(); ++k) {
        const auto verdict = render::Verdict(int(drawn.find("verdict")->samples[k]));
        other += verdict == render::Verdict::hit && truth.roots[k].answer == roots::Answer::hit &&
                 (is_one || truth.roots[k].surface >= 0) &&
                 (truth.roots[k].cap >= 0) != (caps->samples[k] > 0);
    }
    return other;
}

// What tells truths apart: neither how rays are marched nor how a picture is divided.
std::string key_of_truth(std::string scene, Look look) {
    for (const auto& [begin, end] : {std::pair{"\n[isolation]\n", "\n["}, {"\nisolation = ", "\n"}})
        if (const std::size_t at = scene.find(begin); at != scene.npos)
            scene.erase(at, scene.find(end, at + 1) - at);
    look.plan.reset();
    look.stage = {};
    return key_of(scene, look);
}

void check(const Truth& wanted, const Drawn& drawn, std::optional<roots::Truth>& known) {
    const image::Frame& frame = drawn.picture.frame;
    if (!known) known = roots::certify(drawn.scene, drawn.now, frame.width, frame.height);
    const roots::Truth& truth = *known;
    const accuracy::Errors errors = accuracy::compare(drawn.now, frame, truth);
    EXPECT_LE(errors.wrong(), wanted.wrong)
        << "missed " << errors.missed << ", no root " << errors.false_hits
        << ", behind the first or of another surface " << errors.wrong_roots;
    EXPECT_LE(errors.undecided, wanted.undecided);
    EXPECT_EQ(errors.contradicted, 0) << "proofs";
    EXPECT_EQ(other_caps(frame, truth), 0) << "caps";
}

void check(const Methods& methods, const SceneFile& file, const Values& values) {
    stability::HardCase hard{methods.label, with_values(file.scene(), values), {}};
    if (!methods.truth_of.empty()) {
        Values easier = values;
        for (const auto& [name, value] : methods.truth_of) easier[name] = value;
        hard.truth = with_values(file.scene(), easier);
    }
    for (const auto& [method, most] : methods.wrong_ppm) {
        if (method == "default") {
            hard.by_default = most;
            continue;
        }
        const auto entry =
            std::ranges::find(scene::method_traits, method, &scene::MethodTraits::name);
        if (entry == std::end(scene::method_traits))
            throw std::invalid_argument(method + " is no method");
        hard.bounds.push_back({entry->method, most});
    }
    hard.is_cut_off = !methods.any_size;
    stability::expect_bounds(hard);
}

// What tests of several values draw and certify again and again.
struct Known {
    Pictures drawn;
    std::map<std::string, std::optional<roots::Truth>> truths;
};

void check(const Expectations& expected, const SceneFile& file, gpu::Context& context,
           Known& known) {
    const Look& own = expected.pictures.at("");
    if (expected.methods) check(*expected.methods, file, own.with);
    if (!expected.refused.empty()) {
        try {
            draw(context, file.scene(), file.path(), own);
            ADD_FAILURE() << "is drawn, and nothing is wrong with it";
        } catch (const std::exception& error) {
            for (const std::string& words : expected.refused)
                EXPECT_NE(std::string_view(error.what()).find(words), std::string_view::npos)
                    << error.what();
        }
    }
    if (expected.that.empty() && expected.same.empty() && expected.truths.empty()) return;
    for (const auto& [name, look] : expected.pictures)
        if (look.stage == render::StageChoice::compute && !gpu::has_compute(context.info())) return;
    Pictures pictures;
    for (const auto& [name, look] : expected.pictures) {
        auto& once = known.drawn[key_of(file.scene(), look)];
        if (!once)
            once = std::make_shared<const Drawn>(draw(context, file.scene(), file.path(), look));
        pictures[name] = once;
    }
    for (const That& that : expected.that) check(that, pictures);
    for (const Same& same : expected.same) check(same, pictures);
    for (const Truth& truth : expected.truths)
        check(truth, *pictures.at(truth.of),
              known.truths[key_of_truth(file.scene(), expected.pictures.at(truth.of))]);
}

} // namespace

void check(const SceneFile& file, const std::string& test, gpu::Context& context) {
    Known known;
    std::string place = file.path();
    try {
        for (const auto& [tried, expected] : file.expected_of(test)) {
            place = file.path() + (tried.empty() ? "" : ", " + tried);
            SCOPED_TRACE(place);
            check(expected, file, context, known);
        }
    } catch (const std::exception& error) {
        ADD_FAILURE() << place << ": " << error.what();
    }
}

} // namespace isomotion::scenes

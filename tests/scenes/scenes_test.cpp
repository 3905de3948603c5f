// One test for each of the tests of each scene file in a folder, and one for each back end of those
// that every back end draws. A file that is not understood is a test that fails.
#include <algorithm>
#include <cctype>
#include <filesystem>
#include <memory>
#include <set>

#include <gtest/gtest.h>

#include "scenes/check.h"
#include "unit/gpu/every_backend.h"

namespace isomotion::scenes {
namespace {

class SceneTest : public testing::Test {
public:
    SceneTest(std::shared_ptr<const SceneFile> file, std::string test,
              std::optional<gpu::Backend> backend)
        : file_(std::move(file))
        , test_(std::move(test))
        , backend_(backend) {}

    void TestBody() override {
        if (!backend_) {
            static const auto context = gpu::Context::create();
            check(*file_, test_, *context);
            return;
        }
        std::optional<display::OnDisplay> display;
        if (*backend_ == gpu::Backend::glfw) display.emplace();
        const auto context = gpu::open_if_available(*backend_);
        if (!context) GTEST_SKIP() << name(*backend_) << " is not available here";
        check(*file_, test_, *context);
    }

private:
    std::shared_ptr<const SceneFile> file_;
    std::string test_;
    std::optional<gpu::Backend> backend_;
};

class Mistake : public testing::Test {
public:
    explicit Mistake(std::string message)
        : message_(std::move(message)) {}
    void TestBody() override { ADD_FAILURE() << message_; }

private:
    std::string message_;
};

std::string as_name(std::string text) {
    for (char& c : text)
        if (!std::isalnum(static_cast<unsigned char>(c))) c = '_';
    return text;
}

void add(const std::string& suite, std::shared_ptr<const SceneFile> file, const std::string& test,
         std::optional<gpu::Backend> backend) {
    const std::string name =
        as_name(test) + (backend ? "/" + std::string(gpu::name(*backend)) : "");
    testing::RegisterTest(suite.c_str(), name.c_str(), nullptr, nullptr, file->path().c_str(), 1,
                          [=]() -> testing::Test* { return new SceneTest(file, test, backend); });
}

int registered = [] {
    std::set<std::filesystem::path> files;
    for (const auto& entry : std::filesystem::directory_iterator(ISOMOTION_SCENES))
        if (entry.path().extension() == ".toml") files.insert(entry.path());
    for (const auto& path : files) {
        const std::string suite = "Scenes/" + as_name(path.stem().string());
        try {
            const auto file = std::make_shared<const SceneFile>(path);
            for (const std::string& test : file->tests()) {
                if (!file->is_for_every_backend()) {
                    add(suite, file, test, {});
                    continue;
                }
                for (const auto backend :
                     {gpu::Backend::egl, gpu::Backend::osmesa, gpu::Backend::glfw})
                    add(suite, file, test, backend);
            }
        } catch (const std::exception& error) {
            testing::RegisterTest(suite.c_str(), "is_understood", nullptr, nullptr, __FILE__,
                                  __LINE__, [message = std::string(error.what())] {
                                      return static_cast<testing::Test*>(new Mistake(message));
                                  });
        }
    }
    return int(files.size());
}();

} // namespace
} // namespace isomotion::scenes

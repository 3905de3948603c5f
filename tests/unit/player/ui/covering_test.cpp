// What lies over a picture, of frames of Dear ImGui that no driver draws.
#include "player/ui/covering.h"

#include <functional>

#include <gtest/gtest.h>

namespace isomotion::player {
namespace {

constexpr ImGuiWindowFlags plain = ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize |
                                   ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings;

class Covering : public testing::Test {
protected:
    Covering() {
        ImGuiIO& io = ImGui::GetIO();
        io.IniFilename = nullptr;
        io.DisplaySize = {400, 300};
        ImGui::GetStyle().WindowBorderSize = 0; // as the theme has it
        unsigned char* pixels = nullptr;
        int width = 0, height = 0;
        io.Fonts->GetTexDataAsRGBA32(&pixels, &width, &height);
    }
    ~Covering() override { ImGui::DestroyContext(context_); }

    // Whether the rectangle from (100, 100) to (200, 200) is covered by what `widgets` make.
    static bool is_covered_by(const std::function<void()>& widgets) {
        bool found = false;
        for (int settles = 0; settles < 3; ++settles) {
            ImGui::NewFrame();
            widgets();
            ImGui::Render();
            found = is_covered(*ImGui::GetDrawData(), {100, 100}, {200, 200});
        }
        return found;
    }
    static bool is_covered_by_window(ImVec2 corner, ImVec2 size) {
        return is_covered_by([&] {
            ImGui::SetNextWindowPos(corner);
            ImGui::SetNextWindowSize(size);
            ImGui::Begin("window", nullptr, plain);
            ImGui::TextUnformatted("text");
            ImGui::End();
        });
    }

    ImGuiContext* context_ = ImGui::CreateContext();
};

TEST_F(Covering, NothingCoversNothing) {
    EXPECT_FALSE(is_covered_by([] {}));
}

TEST_F(Covering, WindowsBesideItDoNot) {
    EXPECT_FALSE(is_covered_by_window({200, 0}, {200, 300}));
    EXPECT_FALSE(is_covered_by_window({0, 200}, {400, 100}));
    EXPECT_FALSE(is_covered_by_window({0, 0}, {100, 300}));
    EXPECT_FALSE(is_covered_by_window({0, 0}, {400, 100}));
}

TEST_F(Covering, WindowsOverAnyPartOfItDo) {
    EXPECT_TRUE(is_covered_by_window({195, 0}, {200, 300}));
    EXPECT_TRUE(is_covered_by_window({120, 120}, {50, 50}));
    EXPECT_TRUE(is_covered_by_window({0, 0}, {400, 300}));
    EXPECT_TRUE(is_covered_by_window({0, 0}, {105, 105}));
}

TEST_F(Covering, AWindowWithoutBackgroundCoversWhereItDraws) {
    const auto lines = [](ImVec2 from, ImVec2 to) {
        return [from, to] {
            ImGui::SetNextWindowPos({0, 0});
            ImGui::SetNextWindowSize({400, 300});
            ImGui::SetNextWindowBgAlpha(0);
            ImGui::Begin("lines", nullptr, plain | ImGuiWindowFlags_NoBackground);
            ImGui::GetWindowDrawList()->AddLine(from, to, IM_COL32_WHITE);
            ImGui::End();
        };
    };
    EXPECT_FALSE(is_covered_by(lines({10, 10}, {10, 290})));
    EXPECT_TRUE(is_covered_by(lines({150, 10}, {150, 290})));
}

TEST_F(Covering, WhatIsClippedAwayDoesNot) {
    EXPECT_FALSE(is_covered_by([] {
        ImDrawList& list = *ImGui::GetForegroundDrawList();
        list.PushClipRect({0, 0}, {90, 90});
        list.AddRectFilled({0, 0}, {300, 300}, IM_COL32_WHITE);
        list.PopClipRect();
    }));
}

} // namespace
} // namespace isomotion::player

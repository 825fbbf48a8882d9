#include "viewer/model_style.h"

#include <array>
#include <filesystem>
#include <system_error>

namespace sir::viewer {
namespace {

constexpr float kLetters = 14;
constexpr std::array kFonts{
    "/usr/share/fonts/truetype/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/TTF/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu-sans-fonts/DejaVuSans.ttf",
    "/usr/share/fonts/dejavu/DejaVuSans.ttf",
    "/usr/share/fonts/truetype/liberation/LiberationSans-Regular.ttf",
};

// Latin with all its accents, and general punctuation, which scripts may hold; Greek, and the
// operations on sets.
constexpr std::array<ImWchar, 9> kCharacters{0x20,   0x24F,  0x370,  0x3FF, 0x2010,
                                             0x2027, 0x2200, 0x22FF, 0};

void load_letters(float density) {
  ImGuiIO& io = ImGui::GetIO();
  for (const char* file : kFonts) {
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) continue;
    if (io.Fonts->AddFontFromFileTTF(file, kLetters * density, nullptr, kCharacters.data()) ==
        nullptr)
      continue;
    io.FontGlobalScale = 1 / density;
    return;
  }
}

ImVec4 grey(float light, float alpha = 1) { return {light, light, light * 1.04f, alpha}; }
ImVec4 accent(float alpha) { return {0.26f, 0.53f, 0.86f, alpha}; }

}  // namespace

void set_model_style(float density, bool smooth) {
  load_letters(density);
  ImGuiStyle& style = ImGui::GetStyle();
  style.WindowPadding = {10, 8};
  style.FramePadding = {6, 3};
  style.ItemSpacing = {6, 5};
  style.ItemInnerSpacing = {5, 4};
  style.IndentSpacing = 16;
  style.ScrollbarSize = 11;
  style.FrameRounding = style.GrabRounding = style.PopupRounding = 3;
  style.ChildRounding = style.WindowRounding = style.ScrollbarRounding = 3;
  style.AntiAliasedLines = style.AntiAliasedFill = smooth;
  style.AntiAliasedLinesUseTex = false;
  style.WindowTitleAlign = {0.5f, 0.5f};
  ImVec4* colours = style.Colors;
  colours[ImGuiCol_Text] = grey(0.88f);
  colours[ImGuiCol_TextDisabled] = kQuiet;
  colours[ImGuiCol_WindowBg] = grey(0.15f);
  colours[ImGuiCol_ChildBg] = grey(0.15f, 0);
  colours[ImGuiCol_PopupBg] = grey(0.17f);
  colours[ImGuiCol_MenuBarBg] = grey(0.15f);
  colours[ImGuiCol_Border] = grey(0.28f);
  colours[ImGuiCol_FrameBg] = grey(0.22f);
  colours[ImGuiCol_FrameBgHovered] = grey(0.28f);
  colours[ImGuiCol_FrameBgActive] = accent(0.55f);
  colours[ImGuiCol_TitleBg] = colours[ImGuiCol_TitleBgActive] = grey(0.21f);
  colours[ImGuiCol_Button] = grey(0.26f);
  colours[ImGuiCol_ButtonHovered] = grey(0.34f);
  colours[ImGuiCol_ButtonActive] = accent(0.9f);
  colours[ImGuiCol_Header] = grey(0.21f);
  colours[ImGuiCol_HeaderHovered] = grey(0.28f);
  colours[ImGuiCol_HeaderActive] = accent(0.6f);
  colours[ImGuiCol_Separator] = grey(0.28f);
  colours[ImGuiCol_CheckMark] = kAccent;
  colours[ImGuiCol_ScrollbarBg] = grey(0.15f, 0);
  colours[ImGuiCol_ScrollbarGrab] = grey(0.30f);
  colours[ImGuiCol_ScrollbarGrabHovered] = grey(0.38f);
  colours[ImGuiCol_ScrollbarGrabActive] = accent(0.9f);
  colours[ImGuiCol_TextSelectedBg] = accent(0.45f);
  colours[ImGuiCol_DragDropTarget] = kAccent;
  colours[ImGuiCol_ModalWindowDimBg] = grey(0, 0);  // the dialog sees to it
}

void dim_around() {
  const ImVec2 low = ImGui::GetWindowPos(), size = ImGui::GetWindowSize();
  const ImVec2 high{low.x + size.x, low.y + size.y}, all = ImGui::GetIO().DisplaySize;
  ImDrawList& list = *ImGui::GetWindowDrawList();
  const ImU32 shade = ImGui::GetColorU32(ImVec4(0.04f, 0.04f, 0.05f, 0.55f));
  list.PushClipRectFullScreen();
  list.AddRectFilled({0, 0}, {all.x, low.y}, shade);
  list.AddRectFilled({0, high.y}, all, shade);
  list.AddRectFilled({0, low.y}, {low.x, high.y}, shade);
  list.AddRectFilled({high.x, low.y}, {all.x, high.y}, shade);
  list.PopClipRect();
}

void push_main_button() {
  ImGui::PushStyleColor(ImGuiCol_Button, accent(0.75f));
  ImGui::PushStyleColor(ImGuiCol_ButtonHovered, accent(1));
}

void pop_main_button() { ImGui::PopStyleColor(2); }

}  // namespace sir::viewer

// The panel's frame: Dear ImGui between SDL's events and SDL's renderer.
#include "viewer/panel.h"

#include <backends/imgui_impl_sdlrenderer.h>
#include <imgui.h>

#include <optional>

#include "viewer/panel_input.h"
#include "viewer/panel_parts.h"

namespace sir::viewer {
namespace {

constexpr int kPanelWidth = 340;

class ImGuiPanel final : public Panel {
 public:
  ImGuiPanel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer)
      : window_(window), renderer_(renderer), viewer_(viewer) {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;  // leaves no files behind
    ImGuiStyle& style = ImGui::GetStyle();
    style.WindowBorderSize = 0;
    style.AntiAliasedLines = style.AntiAliasedFill = false;  // SDL's software renderer has none
    ImGui_ImplSDLRenderer_Init(renderer);
  }
  ~ImGuiPanel() override { ImGui_ImplSDLRenderer_Shutdown(); }

  int width() const override { return kPanelWidth; }

  bool takes(const SDL_Event& event) override {
    input_.pass(event);
    const ImGuiIO& io = ImGui::GetIO();
    switch (event.type) {
      case SDL_MOUSEMOTION: return holder_.value_or(owner_at(event.motion.x)) == Owner::panel;
      case SDL_MOUSEBUTTONDOWN:
        if (!holder_) holder_ = owner_at(event.button.x);
        return holder_ == Owner::panel;
      case SDL_MOUSEBUTTONUP: {
        const bool mine = holder_ == Owner::panel;
        if (!input_.any_button_held()) holder_.reset();
        return mine;
      }
      case SDL_MOUSEWHEEL: return owner_at(static_cast<int>(io.MousePos.x)) == Owner::panel;
      case SDL_TEXTINPUT: return io.WantTextInput;
      case SDL_KEYDOWN:
        return io.WantTextInput || (event.key.keysym.sym == SDLK_ESCAPE &&
                                    ImGui::IsPopupOpen(nullptr, ImGuiPopupFlags_AnyPopup));
      default: return false;
    }
  }

  void reset() override {
    input_.reset();
    holder_.reset();
  }

  void forget() override { ImGui_ImplSDLRenderer_DestroyDeviceObjects(); }

  void draw() override {
    input_.begin_frame(window_, renderer_);
    ImGui_ImplSDLRenderer_NewFrame();
    ImGui::NewFrame();
    const ImGuiIO& io = ImGui::GetIO();
    ImGui::SetNextWindowPos({io.DisplaySize.x - kPanelWidth, 0});
    ImGui::SetNextWindowSize({kPanelWidth, io.DisplaySize.y});
    ImGui::Begin("panel", nullptr,
                 ImGuiWindowFlags_NoTitleBar | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoMove |
                     ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoBringToFrontOnFocus |
                     ImGuiWindowFlags_NoNav);
    parts_.draw(viewer_);
    ImGui::End();
    ImGui::Render();
    input_.end_frame();
    // The backend leaves the density of the pixels to the renderer's scale.
    SDL_RenderSetScale(renderer_, io.DisplayFramebufferScale.x, io.DisplayFramebufferScale.y);
    ImGui_ImplSDLRenderer_RenderDrawData(ImGui::GetDrawData());
    SDL_RenderSetScale(renderer_, 1, 1);
  }

 private:
  enum class Owner { picture, panel };
  Owner owner_at(int x) const {
    int width = 0;
    SDL_GetWindowSize(window_, &width, nullptr);
    return x >= width - kPanelWidth ? Owner::panel : Owner::picture;
  }

  struct Context {
    Context() { ImGui::CreateContext(); }
    ~Context() { ImGui::DestroyContext(); }
    Context(const Context&) = delete;
    Context& operator=(const Context&) = delete;
  };

  Context context_;
  SDL_Window* window_;
  SDL_Renderer* renderer_;
  Viewer& viewer_;
  PanelInput input_;
  PanelParts parts_;
  std::optional<Owner> holder_;  // of the mouse, while a button is down
};

}  // namespace

std::unique_ptr<Panel> make_panel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer) {
  return std::make_unique<ImGuiPanel>(window, renderer, viewer);
}

}  // namespace sir::viewer

#include "viewer/panel.h"

#include "viewer/panel_frame.h"
#include "viewer/panel_parts.h"

namespace sir::viewer {
namespace {

constexpr int kPanelWidth = 340;

class ImGuiPanel final : public Panel {
 public:
  ImGuiPanel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer)
      : frame_(window, renderer, kPanelWidth), viewer_(viewer) {}

  int width() const override { return kPanelWidth; }
  bool takes(const SDL_Event& event) override { return frame_.takes(event); }
  void reset() override { frame_.reset(); }
  void forget() override { frame_.forget(); }
  void draw() override {
    frame_.draw([this] { parts_.draw(viewer_); });
  }

 private:
  PanelFrame frame_;
  Viewer& viewer_;
  PanelParts parts_;
};

}  // namespace

std::unique_ptr<Panel> make_panel(SDL_Window* window, SDL_Renderer* renderer, Viewer& viewer) {
  return std::make_unique<ImGuiPanel>(window, renderer, viewer);
}

}  // namespace sir::viewer

#include "tests/claim_ball.h"

#include <cmath>
#include <numeric>
#include <vector>

#include "quant/ciede2000.h"
#include "quant/grid.h"
#include "quant/hue_loss.h"
#include "quant/shown_through.h"
#include "tracer/camera.h"
#include "tracer/probe.h"
#include "tracer/render.h"
#include "tracer/scene_file.h"

namespace sir::test {
namespace {

constexpr std::int64_t kBallNode = 6, kBallSurface = 5;  // in docs/claim/ball

Scene scene_with(const std::filesystem::path& base, const Ball& ball) {
  Scene scene = read_scene(base);
  for (CsgNode& node : scene.tree.nodes)
    if (node.number == kBallNode)
      node.placement = {glm::dmat3(ball.radius), {ball.x, ball.radius, ball.z}};
  for (Surface& surface : scene.surfaces)
    if (surface.number == kBallSurface) surface.first.ambient = surface.first.diffuse = ball.colour;
  return scene;
}

std::vector<std::size_t> pixels_of(const Scene& scene, ImageSize size) {
  const auto prober = make_prober(scene, Precision::double_);
  const Camera<double> camera(scene.camera);
  std::vector<std::size_t> pixels;
  for (int j = 0; j < size.height; ++j)
    for (int i = 0; i < size.width; ++i) {
      const auto ray = camera.primary_ray(i, j, size);
      const auto& hits = prober->hits(ray.origin.v, ray.direction.v);
      if (!hits.empty() && hits.front().node == kBallNode)
        pixels.push_back(static_cast<std::size_t>(j * size.width + i));
    }
  return pixels;
}

double rms(const Planes& reference, const Planes& shown) {
  double sum = 0;
  for (std::size_t i = 0; i < reference.size.pixels(); ++i) {
    const Rgb8 a = reference.at(i), b = shown.at(i);
    sum += std::pow(a.r - b.r, 2) + std::pow(a.g - b.g, 2) + std::pow(a.b - b.b, 2);
  }
  return std::sqrt(sum / (3 * static_cast<double>(reference.size.pixels())));
}

}  // namespace

BallImage::BallImage(const std::filesystem::path& base, const Ball& ball, ImageSize size) {
  const Scene scene = scene_with(base, ball);
  RenderOptions options;
  options.size = size;
  image_ = render(scene, options).planes;
  ball_ = pixels_of(scene, size);
  true_ball_ = of_ball(image_);
}

Planes BallImage::of_ball(const Planes& image) const {
  Planes part(ImageSize{static_cast<int>(ball_.size()), 1});
  for (std::size_t i = 0; i < ball_.size(); ++i) part.set(i, image.at(ball_[i]));
  return part;
}

std::set<int> BallImage::hues() const {
  std::set<int> planes;
  for (const auto& plane : quant::hue_loss(true_ball_, true_ball_).planes)
    planes.insert(plane.plane);
  planes.erase(quant::HsvGrid().grey_plane());
  return planes;
}

double BallImage::ball_difference(const Planes& shown) const {
  const auto map = quant::difference_map(true_ball_, of_ball(shown));
  return std::accumulate(map.begin(), map.end(), 0.0) / static_cast<double>(map.size());
}

BallLoss BallImage::loss(quant::Space space, quant::SplitOrder order) const {
  quant::ChooseOptions options;
  options.space = space;
  options.split = order;
  const Planes shown = quant::shown_through(image_, quant::choose_lut(image_, options));
  const Planes ball = of_ball(shown);
  return {rms(true_ball_, ball), rms(image_, shown), quant::hue_loss(true_ball_, ball).weighted,
          quant::hue_loss(image_, shown).alarms};
}

}  // namespace sir::test

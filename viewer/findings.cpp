#include "viewer/findings.h"

#include <utility>

#include "quant/heat_map.h"

namespace sir::viewer {
namespace {

constexpr std::size_t kBins = 64;  // one for each code of the MA120's DAC

}  // namespace

template <typename T>
bool Findings::take(std::shared_ptr<const T>& now, Latest<T>& latest, const Ingredients& of,
                    bool wanted, typename Latest<T>::Make make) {
  std::shared_ptr<const T> found;
  if (wanted) {
    // Asked first: it may become so at any time, when what came before is already in hand.
    const bool current = latest.is_current(of);
    found = latest.get(worker_, of, std::move(make));
    // What is of another picture would be laid over the wrong one.
    if (!current) {
      found = nullptr;
      waiting_ |= latest.error().empty();
    }
  }
  const bool changed = found != now;
  now = std::move(found);
  return changed;
}

bool Findings::update(const Wanted& wanted, const std::array<Side, 2>& sides,
                      const quant::MapOptions& mapping) {
  waiting_ = false;
  bool changed = false;
  for (int side = 0; side < 2; ++side) {
    Wanted here = side < wanted.sides ? wanted : Wanted{};
    if (!sides[at(side)].rendition()) here = {};
    changed |= update_side(side, here, sides[at(side)], mapping);
  }
  return update_duel(wanted, sides) || changed;
}

bool Findings::update_side(int side, const Wanted& wanted, const Side& shown,
                           const quant::MapOptions& mapping) {
  const auto picture = shown.picture();
  // In true colour there is nothing to judge, but still a ray to inspect.
  const auto rendition = shown.true_colour() ? nullptr : shown.rendition();
  const Ingredients of{picture, rendition};
  const std::size_t i = at(side);
  bool changed =
      take(heat_now_[i], heat_[i], of, wanted.map == Map::heat && rendition, [=](std::stop_token) {
        return std::make_shared<const Planes>(quant::heat_map(picture->planes, rendition->seen));
      });
  changed |= take(inspector_now_[i], inspector_[i], of, wanted.inspectors && picture,
                  [=](std::stop_token) {
                    return std::make_shared<const Inspectors>(picture, rendition, mapping);
                  });
  changed |= take(judgement_now_[i], judgement_[i], of, wanted.judgements && rendition,
                  [=](std::stop_token stop) -> std::shared_ptr<const Judgement> {
                    auto judgement = judge(picture->planes, rendition->seen, std::move(stop));
                    if (!judgement) return nullptr;
                    return std::make_shared<const Judgement>(*std::move(judgement));
                  });
  changed |= take(usage_now_[i], usage_[i], of, wanted.usage && rendition, [=](std::stop_token) {
    return std::make_shared<const Usage>(Usage{lut_usage(rendition->lut, rendition->indices),
                                               primary_histogram(picture->planes, kBins),
                                               primary_histogram(rendition->seen, kBins)});
  });
  return changed;
}

bool Findings::update_duel(const Wanted& wanted, const std::array<Side, 2>& sides) {
  const auto picture = sides[0].picture();
  const auto a = sides[0].rendition(), b = sides[1].rendition();
  const bool possible = wanted.sides == 2 && wanted.map == Map::duel && a && b &&
                        picture == sides[1].picture() && !sides[0].true_colour() &&
                        !sides[1].true_colour();
  return take(
      duel_now_, duel_, {picture, a, b}, possible,
      [=](std::stop_token stop) -> std::shared_ptr<const DuelAndMap> {
        Duel found = viewer::duel(picture->planes, a->seen, b->seen, stop);
        if (stop.stop_requested()) return nullptr;
        Planes map = duel_map(picture->planes, found);
        return std::make_shared<const DuelAndMap>(DuelAndMap{std::move(found), std::move(map)});
      });
}

const Planes* Findings::map(int side) const {
  if (duel_now_) return &duel_now_->map;
  return heat_now_[at(side)].get();
}

Inspector* Findings::inspector(int side) const {
  const auto& now = inspector_now_[at(side)];
  return now ? &now->inspector : nullptr;
}

}  // namespace sir::viewer

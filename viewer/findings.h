// What is worked out about the pictures on the screen while a person looks at them: maps, the
// inspector, judgements. The thesis (4) judged by eye.
#pragma once

#include <array>
#include <memory>
#include <utility>

#include "viewer/duel.h"
#include "viewer/inspection.h"
#include "viewer/judgement.h"
#include "viewer/latest.h"
#include "viewer/lut_usage.h"
#include "viewer/side.h"

namespace sir::viewer {

/// What may be laid over the picture.
enum class Map { none, heat, duel };

/// Results for the two sides as they are now, worked out in the background. For the window's
/// thread; no member waits.
class Findings {
 public:
  explicit Findings(Worker& worker) : worker_(worker) {}

  /// What somebody looks at; the rest is not worked out.
  struct Wanted {
    Map map = Map::none;
    bool inspectors = false, judgements = false, usage = false;
    int sides = 1;  ///< 2: a duel
  };

  /// Asks for what is wanted of what the sides show. Returns whether any answer is new.
  bool update(const Wanted& wanted, const std::array<Side, 2>& sides,
              const quant::MapOptions& mapping);

  /// Whether an answer is still to come.
  bool waiting() const { return waiting_; }

  /// Null where it is not wanted or not there yet.
  const Planes* map(int side) const;
  const Duel* duel() const { return duel_now_ ? &duel_now_->duel : nullptr; }
  Inspector* inspector(int side) const;
  const Judgement* judgement(int side) const { return judgement_now_[at(side)].get(); }
  const LutUsage* usage(int side) const {
    return usage_now_[at(side)] ? &usage_now_[at(side)]->lut : nullptr;
  }
  const PrimaryHistogram* histogram_before(int side) const {
    return usage_now_[at(side)] ? &usage_now_[at(side)]->before : nullptr;
  }
  const PrimaryHistogram* histogram_after(int side) const {
    return usage_now_[at(side)] ? &usage_now_[at(side)]->after : nullptr;
  }

 private:
  struct DuelAndMap {
    Duel duel;
    Planes map;
  };

  struct Usage {
    LutUsage lut;
    PrimaryHistogram before, after;
  };

  // An inspector remembers what it was asked, so that asking changes it.
  struct Inspectors {
    Inspectors(std::shared_ptr<const Picture> picture, std::shared_ptr<const Rendition> rendition,
               const quant::MapOptions& mapping)
        : inspector(std::move(picture), std::move(rendition), mapping) {}
    mutable Inspector inspector;
  };

  static std::size_t at(int side) { return static_cast<std::size_t>(side); }
  template <typename T>
  bool take(std::shared_ptr<const T>& now, Latest<T>& latest, const Ingredients& of, bool wanted,
            typename Latest<T>::Make make);
  bool update_side(int side, const Wanted& wanted, const Side& shown,
                   const quant::MapOptions& mapping);
  bool update_duel(const Wanted& wanted, const std::array<Side, 2>& sides);

  Worker& worker_;
  bool waiting_ = false;
  std::array<Latest<Planes>, 2> heat_;
  std::array<Latest<Inspectors>, 2> inspector_;
  std::array<Latest<Judgement>, 2> judgement_;
  std::array<Latest<Usage>, 2> usage_;
  Latest<DuelAndMap> duel_;
  std::array<std::shared_ptr<const Planes>, 2> heat_now_;
  std::array<std::shared_ptr<const Inspectors>, 2> inspector_now_;
  std::array<std::shared_ptr<const Judgement>, 2> judgement_now_;
  std::array<std::shared_ptr<const Usage>, 2> usage_now_;
  std::shared_ptr<const DuelAndMap> duel_now_;
};

}  // namespace sir::viewer

#include "eltek/phosphor.h"

namespace sir::eltek {
namespace {

constexpr Phosphors kSmpteC{"smpte-c", {{{0.630, 0.340}, {0.310, 0.595}, {0.155, 0.070}}}};
constexpr Phosphors kH273{"p22-h273", {{{0.630, 0.340}, {0.295, 0.605}, {0.155, 0.077}}}};
constexpr Phosphors kDosbox{"p22-dosbox", {{{0.647, 0.343}, {0.310, 0.594}, {0.148, 0.062}}}};

constexpr White kD65{"d65", {0.3127, 0.3290}};
constexpr White k9300{"9300k", {0.2831, 0.2971}};

}  // namespace

const Phosphors& phosphors(PhosphorSet set) {
  switch (set) {
    case PhosphorSet::smpte_c: break;
    case PhosphorSet::p22_h273: return kH273;
    case PhosphorSet::p22_dosbox: return kDosbox;
  }
  return kSmpteC;
}

const White& white(WhitePoint point) { return point == WhitePoint::k9300 ? k9300 : kD65; }

}  // namespace sir::eltek

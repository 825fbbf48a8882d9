// The phosphors and whites of colour monitors, by name. The thesis names neither for the MA120:
// what stands here is our choice among sets that were in use.
#pragma once

#include <array>
#include <string_view>

namespace sir::eltek {

/// CIE 1931 x and y.
struct Chromaticity {
  double x = 0, y = 0;
  friend bool operator==(const Chromaticity&, const Chromaticity&) = default;
};

/// Two sets go by "P22", and differ; so the name says where each is from.
enum class PhosphorSet {
  smpte_c,    ///< SMPTE RP 145: the studio monitors of the 1980s
  p22_h273,   ///< ITU-T H.273, ColourPrimaries 22
  p22_dosbox  ///< what DOSBox Staging takes for the P22 of computer monitors
};

struct Phosphors {
  std::string_view name;                ///< as on the command line
  std::array<Chromaticity, 3> primary;  ///< red, green, blue
};

const Phosphors& phosphors(PhosphorSet set);

enum class WhitePoint {
  d65,   ///< .3127 .3290, the white of television and of sRGB
  k9300  ///< 9300 K on the daylight locus
};

struct White {
  std::string_view name;
  Chromaticity at;
};

/// "9300 K" is two whites. Ours is the point of that temperature on the CIE's daylight locus,
/// .2831 .2971, as computer monitors had it at a knob. The other, 9300 K + 27 MPCD (.281 .311), was
/// that of Japanese television sets and is greener.
const White& white(WhitePoint point);

}  // namespace sir::eltek

// How far two colours are apart, as the method `best` counts it: by the eye or by the bytes.
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "quant/ciede2000.h"
#include "tracer/planes.h"

namespace sir::quant {

/// What a LUT is to be good at, and by what its entries are compared with a pixel.
enum class Goal : std::uint8_t {
  perceptual,  ///< little CIEDE2000
  psnr         ///< little squared error of the bytes
};

/// A squared distance around a colour: x, y, z being the differences of the three coordinates,
/// xx x^2 + yy y^2 + zz z^2 + yz y z. Never negative. x is coupled to neither y nor z, which
/// makes a search along x exact (quant/sweep_search.h) and sums of forms easy to solve.
struct Form {
  float xx = 1, yy = 1, zz = 1, yz = 0;

  float operator()(const glm::vec3& difference) const {
    return xx * difference.x * difference.x +
           (yy * difference.y * difference.y + zz * difference.z * difference.z +
            yz * difference.y * difference.z);
  }
};

/// CIEDE2000 for colours close to `at`: the form whose value at a small difference of Lab
/// (x = l, y = a, z = b) is the square of CIEDE2000, up to terms of third order. The factors of
/// the standard (Sharma, Wu and Dalal 2005), which it takes at the mean of two colours, are taken
/// at the one. It is what CIEDE2000 is made for, differences of a few units.
Form local_ciede2000(const Lab& at);

/// Colours as points with forms. For Goal::perceptual a colour's point is its Lab, and its form
/// the local CIEDE2000 at the centre of the cube of 4x4x4 byte colours that it lies in: the form
/// changes by a few percent from one cube to the next. For Goal::psnr points are the bytes in
/// axes turned so that the first is the grey axis, and every form is the identity.
///
/// The difference of a colour and an entry, form_of(colour)(point_of(colour) - point_of(entry)),
/// is a float, worked out in this order; whoever searches for the least of them agrees to the bit.
/// Remembers what it has worked out; not for use by two threads at once.
class ColourMeasure {
 public:
  explicit ColourMeasure(Goal goal);

  Goal goal() const { return goal_; }
  glm::vec3 point_of(Rgb8 colour);
  Form form_of(Rgb8 colour);

  float difference(Rgb8 colour, Rgb8 entry) {
    return form_of(colour)(point_of(colour) - point_of(entry));
  }

 private:
  struct KnownPoint {
    std::uint32_t colour = 0xFFFFFFFF;  // no colour of 24 bits
    glm::vec3 point{};
  };

  Goal goal_;
  std::vector<KnownPoint> points_;           // one for each hash of a colour
  std::vector<std::uint32_t> form_of_cube_;  // 0 until it is asked for
  std::vector<Form> forms_;                  // the first is no cube's
};

}  // namespace sir::quant

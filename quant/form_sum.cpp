#include "quant/form_sum.h"

namespace sir::quant {

FormSum& FormSum::operator+=(const FormSum& other) {
  points += other.points;
  weight += other.weight;
  xx += other.xx;
  yy += other.yy;
  zz += other.zz;
  yz += other.yz;
  x += other.x;
  y += other.y;
  z += other.z;
  rest += other.rest;
  bytes += other.bytes;
  return *this;
}

}  // namespace sir::quant

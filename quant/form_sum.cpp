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

FormSum FormSum::operator-(const FormSum& other) const {
  FormSum less = *this;
  less.points -= other.points;
  less.weight -= other.weight;
  less.xx -= other.xx;
  less.yy -= other.yy;
  less.zz -= other.zz;
  less.yz -= other.yz;
  less.x -= other.x;
  less.y -= other.y;
  less.z -= other.z;
  less.rest -= other.rest;
  less.bytes -= other.bytes;
  return less;
}

}  // namespace sir::quant

// Equality to the last bit of what files hold; line numbers do not count.
#pragma once

#include <vector>

#include "tracer/scene.h"

namespace sir::fuzz {

bool same(const CsgTree& a, const CsgTree& b);
bool same(const CameraFile& a, const CameraFile& b);
bool same(const Lighting& a, const Lighting& b);
bool same(const std::vector<Surface>& a, const std::vector<Surface>& b);

}  // namespace sir::fuzz

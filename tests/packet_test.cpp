// Sixteen rays at once are, bit for bit, sixteen rays.
#include <gtest/gtest.h>

#include <bit>

#include "tests/instruction_sets.h"
#include "tests/packet_scenes.h"
#include "tracer/packet_intersect.h"

namespace sir {
namespace {

template <typename T>
auto bits_of(T number) {
  if constexpr (sizeof(T) == 4) return std::bit_cast<std::uint32_t>(number);
  else return std::bit_cast<std::uint64_t>(number);
}

// Classifier::gather() up to what the start makes of it.
template <typename T>
Crossing scalar_crossing(const Leaf<T>& leaf, const RayCena<T>& ray, Span<T>& span) {
  const auto& d = ray.direction.v;
  const T speed = std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)});
  if (!(speed > 0) || !std::isfinite(speed)) return Crossing::misses;
  const T own = std::ldexp(T(1), -std::ilogb(speed));
  bool tame = std::isnormal(speed) && std::isnormal(own);
  for (int axis = 0; axis < 3; ++axis) {
    const T size = std::abs(d[axis]);
    tame = tame && (size == 0 || size * own > Numeric<T>::kWellAboveUnderflow);
  }
  const T pace = own * leaf.pace;
  if (!tame || !leaf.tame || !std::isnormal(pace)) return Crossing::unsure;
  const Crossing crossing = intersect(leaf.kind, leaf.to_local(ray, pace), span);
  if (crossing == Crossing::crosses) {
    span.enter *= pace;
    span.leave *= pace;
    span.enter_error *= pace;
    span.leave_error *= pace;
  }
  return crossing;
}

// A ray that is likely to be hard for a primitive in a place.
template <typename T>
RayCena<T> hard_ray(std::mt19937_64& random, const Placement& placement) {
  std::uniform_real_distribution<double> any(-2, 2);
  const auto coordinate = [&]() -> double {
    switch (random() % 8) {
      case 0: return 0.0;
      case 1: return random() % 2 ? 1.0 : -0.0;
      case 2: return std::round(any(random));
      case 3: return 1 + any(random) * 1e-9;
      default: return any(random);
    }
  };
  const auto local = [&] { return glm::dvec3(coordinate(), coordinate(), coordinate()); };
  const glm::dvec3 from = placement.linear * local() + placement.translation;
  const glm::dvec3 through = placement.linear * local() + placement.translation;
  glm::dvec3 direction = through - from, origin = from;
  switch (random() % 10) {
    case 0: direction[static_cast<int>(random() % 3)] = random() % 2 ? 0.0 : -0.0; break;
    case 1: direction *= 1e-30; break;
    case 2: direction *= std::numeric_limits<T>::max_exponent > 200 ? 1e200 : 1e30; break;
    case 3: origin -= direction * 1e5; break;
    case 4: origin -= direction * 1e12; break;
    default: break;
  }
  if (random() % 64 == 0) {
    constexpr double kOdd[] = {std::numeric_limits<double>::infinity(),
                               std::numeric_limits<double>::quiet_NaN(), 1e-310, 1e300, 0.0};
    (random() % 2 ? direction : origin)[static_cast<int>(random() % 3)] = kOdd[random() % 5];
  }
  return {{glm::vec<3, T>(origin)}, {glm::vec<3, T>(direction)}};
}

// What a packet says of a primitive and some rays is what the scalar code says.
template <typename T>
void compare_primitive(const Leaf<T>& leaf, const RayPacket<T>& packet, int* tally) {
  const PacketSpans<T> found = intersect_packet(PacketLeaf<T>(leaf, 0), packet);
  for (std::size_t lane = 0; lane < kPacketLanes; ++lane) {
    Span<T> expected;
    const Crossing crossing = scalar_crossing(leaf, packet.ray(lane), expected);
    const bool crosses = found.crosses >> lane & 1u, unsure = found.unsure >> lane & 1u;
    // A coordinate of the origin that is no number cannot be told from one that
    // rounding has eaten: more than the scalar code may be unsure of it.
    const auto& o = packet.ray(lane).origin.v;
    if (!(std::isfinite(o.x) && std::isfinite(o.y) && std::isfinite(o.z))) {
      ASSERT_FALSE(crosses);
      continue;
    }
    ASSERT_EQ(crosses, crossing == Crossing::crosses) << "lane " << lane;
    ASSERT_EQ(unsure, crossing == Crossing::unsure) << "lane " << lane;
    ++tally[static_cast<int>(crossing)];
    if (!crosses) continue;
    const Span<T> span = found.span(lane);
    ASSERT_EQ(bits_of(span.enter + T(0)), bits_of(expected.enter + T(0)));
    ASSERT_EQ(bits_of(span.leave + T(0)), bits_of(expected.leave + T(0)));
    ASSERT_EQ(bits_of(span.enter_error), bits_of(expected.enter_error));
    ASSERT_EQ(bits_of(span.leave_error), bits_of(expected.leave_error));
    ASSERT_EQ(span.enter_face, expected.enter_face);
    ASSERT_EQ(span.leave_face, expected.leave_face);
  }
}

template <typename T>
void compare_primitives(int primitives, const char* set) {
  SCOPED_TRACE(set);
  std::mt19937_64 random(5);
  int tally[3] = {};
  for (int n = 0; n < primitives; ++n) {
    Placement placement = random() % 3 ? test::random_placement(random, 1, random() % 2)
                                       : test::placed(glm::dvec3(1 + double(random() % 3)),
                                                      glm::dvec3(double(random() % 3)));
    if (random() % 8 == 0) placement.linear *= random() % 2 ? 1e-9 : 1e9;
    if (random() % 8 == 0) placement.linear[0] *= 1e-6;
    if (random() % 50 == 0) placement.linear *= 1e-100;
    test::SceneBuilder build;
    const auto kind = static_cast<PrimitiveKind>(n % 4);
    const auto solid = build_solid<T>(build.finish(build.primitive(kind, placement)));
    for (int k = 0; k < 16; ++k) {
      RayPacket<T> packet;
      for (std::size_t lane = 0; lane < kPacketLanes; ++lane)
        packet.set(lane, hard_ray<T>(random, placement));
      ASSERT_NO_FATAL_FAILURE(compare_primitive(solid.leaves[0], packet, tally))
          << "primitive " << n << ", packet " << k;
    }
  }
  for (const int count : tally) EXPECT_GT(count, primitives);
}

TEST(Packet, MeetsAPrimitiveAsOneRayDoes) {
  test::with_each_instruction_set([](const char* set) {
    compare_primitives<double>(6000, set);
    compare_primitives<float>(6000, set);
  });
}

}  // namespace
}  // namespace sir

#include "tests/exact_oracle.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace sir::test {
namespace {

bool inside_of(Operation operation, bool left, bool right) {
  if (operation == Operation::union_of) return left || right;
  return left && (operation == Operation::intersection ? right : !right);
}

}  // namespace

ExactOracle::ExactOracle(const Scene& scene) : scene_(scene) {
  // A stack, for chains of any depth; parents come out before children.
  std::vector<std::size_t> open{scene_.tree.root};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    upwards_.push_back(at);
    const CsgNode& node = scene_.tree.nodes[at];
    if (node.composite) {
      open.push_back(node.left);
      open.push_back(node.right);
    } else {
      leaves_.push_back({at, ExactPlacement(node.placement)});
    }
  }
  std::reverse(upwards_.begin(), upwards_.end());
}

// How far, in SC_LOCAL, roundings of the scene can move a point of the ray near the
// primitive: each coordinate of the point in SC_CENA is off by roundings of the
// translation, of what is left of the origin after it, of t direction (which
// reaches from there to the solid) and of the matrix entries.
double ExactOracle::margin_of(const Leaf& leaf, const glm::dvec3& origin,
                              const Allowance& allowance) const {
  if (allowance.roundings == 0) return 0;
  const Placement& placement = scene_.tree.nodes[leaf.node].placement;
  const Real unit = leaf.placement.determinant.real();
  double worst = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    double moved = 0;
    for (int j = 0; j < 3; ++j) {
      double size =
          std::abs(placement.translation[j]) + 2 * std::abs(origin[j] - placement.translation[j]);
      for (int k = 0; k < 3; ++k) size += 2 * std::abs(placement.linear[k][j]);
      const Real entry = leaf.placement.adjugate[i][static_cast<std::size_t>(j)].real() / unit;
      moved += size * abs(entry).convert_to<double>();
    }
    worst = std::max(worst, moved);
  }
  return allowance.roundings * std::ldexp(worst, -allowance.digits);
}

// Intersects one primitive; false: OUT. With a margin the primitive is also taken
// grown and shrunk by it: where these tell another story, nothing is definite,
// and otherwise they say how far the ends can move.
bool ExactOracle::cross(const Leaf& leaf, const HomogeneousRay& ray, double margin,
                        const Allowance& allowance, Crossed& crossed, bool& definite) const {
  const PrimitiveKind kind = scene_.tree.nodes[leaf.node].kind;
  const ExactSpan span = exact_span(kind, ray);
  std::vector<ExactSpan> varied;
  if (margin > 0) varied = {exact_span(kind, ray, margin), exact_span(kind, ray, -margin)};
  for (const ExactSpan& other : varied) {
    if (other.hit == span.hit && other.enters.size() == span.enters.size() &&
        other.leaves.size() == span.leaves.size())
      continue;
    definite = false;
    varied.clear();
    break;
  }
  if (!span.hit) return false;

  const auto end_of = [&](std::vector<Crossing> ExactSpan::*side, bool enters) {
    const std::vector<Crossing>& all = span.*side;
    std::vector<Real> slack(all.size(), 0);
    for (std::size_t i = 0; i < all.size(); ++i)
      for (const ExactSpan& other : varied)
        slack[i] = (std::max)(slack[i], Real(abs((other.*side)[i].t - all[i].t)));
    std::size_t at = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
      if (enters ? all[i].t > all[at].t : all[i].t < all[at].t) at = i;
    End end;
    end.t = all[at].t;
    end.slack = slack[at];
    end.face = all[at].face;
    std::vector<std::size_t> chain{at};
    for (std::size_t i = 0; i < all.size(); ++i) {
      if (i == at) continue;
      const Comparison near =
          compare_events(all[i].t, all[at].t, allowance.digits, slack[i] + slack[at]);
      definite = definite && near.definite;
      if (near.nearness == Nearness::one_event) {
        end.face = std::min(end.face, all[i].face);
        // Another that is near this one only: a chain, on which the rule for
        // faces is silent.
        for (std::size_t k = 0; k < all.size(); ++k)
          if (compare_events(all[k].t, all[i].t, allowance.digits).nearness ==
                  Nearness::one_event &&
              compare_events(all[k].t, all[at].t, allowance.digits).nearness == Nearness::apart)
            definite = false;
      }
    }
    end.own_face = end.face == all[at].face;
    return end;
  };
  crossed.enter = end_of(&ExactSpan::enters, true);
  crossed.leave = end_of(&ExactSpan::leaves, false);
  return true;
}

ExactOracle::Sweep ExactOracle::sweep(const glm::dvec3& origin, const glm::dvec3& direction,
                                      const Allowance& allowance) const {
  Sweep result;
  for (std::size_t i = 0; i < leaves_.size(); ++i) {
    Crossed crossed{i, {}, {}};
    const HomogeneousRay ray = leaves_[i].placement.to_local(origin, direction);
    if (cross(leaves_[i], ray, margin_of(leaves_[i], origin, allowance), allowance, crossed,
              result.definite))
      result.crossed.push_back(crossed);
  }
  std::vector<std::pair<End*, const Crossed*>> ends;
  for (Crossed& crossed : result.crossed) {
    ends.push_back({&crossed.enter, &crossed});
    ends.push_back({&crossed.leave, &crossed});
  }
  std::sort(ends.begin(), ends.end(),
            [](const auto& a, const auto& b) { return a.first->t < b.first->t; });
  // Where the same primitive stands twice, whatever rounds one rounds both.
  const auto same_surface = [&](const auto& a, const auto& b) {
    const CsgNode& one = scene_.tree.nodes[leaves_[a.second->leaf].node];
    const CsgNode& other = scene_.tree.nodes[leaves_[b.second->leaf].node];
    const bool both_enter = a.first == &a.second->enter && b.first == &b.second->enter;
    const bool both_leave = a.first == &a.second->leave && b.first == &b.second->leave;
    return (both_enter || both_leave) && one.kind == other.kind &&
           one.placement.linear == other.placement.linear &&
           one.placement.translation == other.placement.translation;
  };
  for (std::size_t i = 0; i < ends.size(); ++i) {
    End& end = *ends[i].first;
    // Whether a boundary is reported; without a slack the sign is exact.
    if (end.slack > 0 && abs(end.t) <= end.slack) result.definite = false;
    bool joins = false;
    if (i > 0) {
      const End& previous = *ends[i - 1].first;
      const Comparison near =
          compare_events(previous.t, end.t, allowance.digits,
                         same_surface(ends[i - 1], ends[i]) ? Real(0) : previous.slack + end.slack);
      joins = near.nearness == Nearness::one_event;
      result.definite = result.definite && near.definite;
    }
    if (joins) {
      result.last.back() = end.t;
    } else {
      result.first.push_back(end.t);
      result.last.push_back(end.t);
    }
    end.cluster = result.first.size() - 1;
  }
  return result;
}

ExactOracle::States ExactOracle::before_cluster(const Sweep& sweep, std::size_t cluster) const {
  States states(scene_.tree.nodes.size(), 0);
  for (const Crossed& crossed : sweep.crossed)
    states[leaves_[crossed.leaf].node] =
        crossed.enter.cluster < cluster && crossed.leave.cluster >= cluster;
  combine(states);
  return states;
}

void ExactOracle::combine(States& states) const {
  for (const std::size_t at : upwards_) {
    const CsgNode& node = scene_.tree.nodes[at];
    if (node.composite)
      states[at] = inside_of(node.operation, states[node.left] != 0, states[node.right] != 0);
  }
}

// Down from the root along children that changed in the direction that makes
// the change; of the primitives reached the lowest node, then its face.
ExactHit ExactOracle::named(const Sweep& sweep, std::size_t cluster, const States& before,
                            const States& after) const {
  ExactHit hit;
  bool found = false;
  std::vector<std::size_t> open{scene_.tree.root};
  while (!open.empty()) {
    const std::size_t at = open.back();
    open.pop_back();
    const CsgNode& node = scene_.tree.nodes[at];
    if (node.composite) {
      const bool turned = node.operation == Operation::difference;
      const auto changed_to = [&](std::size_t child, bool state) {
        return before[child] != after[child] && (after[child] != 0) == state;
      };
      if (changed_to(node.left, after[at] != 0)) open.push_back(node.left);
      if (changed_to(node.right, (after[at] != 0) != turned)) open.push_back(node.right);
      continue;
    }
    const auto crossed = std::find_if(sweep.crossed.begin(), sweep.crossed.end(),
                                      [&](const Crossed& c) { return leaves_[c.leaf].node == at; });
    const End& end = crossed->enter.cluster == cluster ? crossed->enter : crossed->leave;
    if (found && std::pair(hit.node, hit.face) <= std::pair(node.number, end.face)) continue;
    found = true;
    hit = {end.t, false, node.number, end.face, at, end.own_face, end.slack};
  }
  hit.entering = after[scene_.tree.root] != 0;
  return hit;
}

ExactAnswer ExactOracle::answer(const glm::dvec3& origin, const glm::dvec3& direction,
                                const Allowance& allowance) const {
  const Sweep line = sweep(origin, direction, allowance);
  ExactAnswer result;
  result.definite = line.definite;
  States before = before_cluster(line, 0);
  for (std::size_t cluster = 0; cluster < line.first.size(); ++cluster) {
    States after = before_cluster(line, cluster + 1);
    if (before[scene_.tree.root] != after[scene_.tree.root]) {
      const ExactHit hit = named(line, cluster, before, after);
      if (hit.t >= 0) result.hits.push_back(hit);
    }
    before = std::move(after);
  }
  return result;
}

std::string ExactOracle::disagreement(const glm::dvec3& origin, const glm::dvec3& direction,
                                      int digits, std::size_t stretches) const {
  const Sweep line = sweep(origin, direction, {digits, 0});
  const std::size_t count = line.first.size() + 1;
  const std::size_t step = std::max<std::size_t>(1, count / std::max<std::size_t>(1, stretches));
  std::vector<HomogeneousRay> local;
  for (const Leaf& leaf : leaves_) local.push_back(leaf.placement.to_local(origin, direction));
  for (std::size_t k = 0; k < count; k += step) {
    Real middle = 0;
    if (count > 1 && k == 0) middle = line.first[0] - abs(line.first[0]) - 1;
    else if (count > 1 && k == count - 1) middle = line.last[k - 1] + abs(line.last[k - 1]) + 1;
    else if (count > 1) middle = (line.last[k - 1] + line.first[k]) / 2;
    const double t = middle.convert_to<double>();
    const States swept = before_cluster(line, k);
    States at_point(swept.size(), 0);
    for (std::size_t i = 0; i < leaves_.size(); ++i) {
      // A primitive thinner than an event is nowhere.
      const std::size_t node = leaves_[i].node;
      at_point[node] = exactly_inside(scene_.tree.nodes[node].kind, local[i], t);
      if (at_point[node] == swept[node]) continue;
      std::ostringstream text;
      text.precision(17);
      text << "node " << scene_.tree.nodes[node].number << " at t = " << t << ": sweep says "
           << (swept[node] ? "inside" : "outside");
      return text.str();
    }
    combine(at_point);
    if (at_point[scene_.tree.root] != swept[scene_.tree.root]) return "the tree's value differs";
  }
  return {};
}

}  // namespace sir::test

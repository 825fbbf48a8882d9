// Solids at random, commands for their parts, and what taking a solid apart and putting it together
// again makes of them.
#pragma once

#include <random>
#include <string>
#include <utility>
#include <vector>

#include "modeler/command_line.h"
#include "modeler/operations.h"
#include "tests/modeler_fixture.h"

namespace sir::test {

using modeler::Node;
using modeler::NodePtr;

class PartsTest : public ModelerTest {
 protected:
  static constexpr const char* kKinds[] = {"cube", "sphere", "cone", "cylinder"};
  static constexpr const char* kOperations[] = {"union", "difference", "intersection"};
  static constexpr int kFaces[] = {6, 1, 2, 3};

  // One surface number, or one for each face.
  static std::string surfaces(std::mt19937_64& random, int faces) {
    std::string text;
    const int count = random() % 2 == 0 ? 1 : faces;
    for (int i = 0; i < count; ++i) text += " " + std::to_string(random() % 5);
    return text;
  }

  // A solid of so many primitives at random places: parts occur in it twice, and are transformed,
  // numbered and labelled on the way. Returns its name.
  std::string grow(std::mt19937_64& random, int primitives) {
    std::vector<std::string> names;
    int next = 0;
    const auto fresh = [&] { return "n" + std::to_string(next++); };
    const auto number = [&] { return std::to_string((int(random() % 41) - 20) * 0.1); };
    while (int(names.size()) < primitives) {
      const std::string name = fresh();
      if (!names.empty() && random() % 4 == 0) {
        say("copy " + names[random() % names.size()] + " " + name);
      } else {
        const std::size_t kind = random() % 4;
        say("create " + name + " " + kKinds[kind] + surfaces(random, kFaces[kind]));
      }
      say("translate " + name + " " + number() + " " + number() + " " + number());
      names.push_back(name);
    }
    while (names.size() > 1) {
      const std::size_t left = random() % names.size();
      std::string parts[2];
      parts[0] = names[left];
      names.erase(names.begin() + std::ptrdiff_t(left));
      const std::size_t right = random() % names.size();
      // A solid that comes twice, its parts the same nodes both times.
      if (random() % 4 == 0) say("copy " + parts[0] + " " + (parts[1] = fresh()));
      else {
        parts[1] = names[right];
        names.erase(names.begin() + std::ptrdiff_t(right));
      }
      const std::string name = fresh();
      say("combine " + name + " " + parts[0] + " " + kOperations[random() % 3] + " " + parts[1] +
          " apart");
      // An empty one cannot be turned.
      if (random() % 4 == 0 && !modeler::is_empty(solid(name).bounds))
        say("rotate " + name + " y " + number());
      if (random() % 4 == 0) say("label " + name + " same");
      if (random() % 4 == 0) say("number " + name + " " + std::to_string(next) + " 7");
      names.push_back(name);
    }
    return names.front();
  }

  // A command for a part, without its name.
  static std::pair<std::string, std::string> draw(std::mt19937_64& random, const Node& part) {
    const auto number = [&] { return std::to_string((int(random() % 61) - 30) * 0.1); };
    const auto numbers = [&](int count) {
      std::string text;
      for (int i = 0; i < count; ++i) text += " " + number();
      return text;
    };
    switch (random() % 9) {
      case 0:
      case 1: return {"translate", numbers(3)};
      case 2: return {"scale", numbers(random() % 2 == 0 ? 1 : 3)};
      case 3: return {"rotate", std::string(" ") + "xyz"[random() % 3] + numbers(1)};
      case 4: return {"matrix", numbers(12)};
      case 5: return {"transform", " rotation z" + numbers(1)};
      case 6: return {"label", " \"another one\""};
      case 7: {
        const auto* primitive = part.primitive();
        return {"paint", surfaces(random, primitive != nullptr ? face_count(primitive->kind) : 1)};
      }
      default: return {"operation", std::string(" ") + kOperations[random() % 3]};
    }
  }

  // The .CSG, and what each node keeps of one.
  static std::string text_of(const Node& tree) {
    std::string text = csg_text(modeler::to_csg(tree));
    for (const Node* node : modeler::preorder(tree))
      text += std::to_string(node->slot.number) + " " + std::to_string(node->slot.position) + "\n";
    return text;
  }

  // What splitting, the command and combining again give; the names that are in the list meanwhile
  // do not count. Empty where it is refused.
  static std::string by_hand(const NodePtr& tree, std::size_t place, const std::string& command,
                             const std::string& rest) {
    modeler::Lsu solids;
    solids.apply({{0, nullptr, entry("x", tree)}});
    struct Parent {
      const Node* node;
      bool left;
      NodePtr other;
      bool met;
    };
    std::vector<Parent> parents;
    const Node* at = tree.get();
    for (std::size_t left = place; left > 0;) {
      const auto& composite = *at->composite();
      const bool is_left = left <= composite.left->count;
      left -= is_left ? 1 : 1 + composite.left->count;
      parents.push_back({at, is_left, is_left ? composite.right : composite.left,
                         modeler::meet(composite.left->bounds, composite.right->bounds)});
      const modeler::Changes changes = modeler::split(solids, "x");
      // The part alone stays, under the name x.
      const NodePtr part = changes[is_left ? 1 : 2].after->solid.tree();
      solids = {};
      solids.apply({{0, nullptr, entry("x", part)}});
      at = part.get();
    }
    NodePtr part = solids.find("x")->solid.tree();
    if (command == "operation") {
      const auto* composite = part->composite();
      if (composite == nullptr) return {};
      const Operation operation =
          modeler::value_of(modeler::operations(), modeler::split_words(rest).front(), "operation");
      part = joined(*part, composite->left, operation, composite->right, false);
    } else if (command == "paint") {
      part = repainted(part, modeler::split_words(rest));
    } else {
      part = done_alone(part, command, rest);
    }
    for (auto parent = parents.rbegin(); part && parent != parents.rend(); ++parent)
      part = joined(*parent->node, parent->left ? part : parent->other,
                    parent->node->composite()->operation, parent->left ? parent->other : part,
                    !parent->met);
    return part ? text_of(*part) : std::string();
  }

 private:
  static modeler::EntryPtr entry(const std::string& name, const NodePtr& tree) {
    return std::make_shared<const modeler::Entry>(
        modeler::Entry{name, modeler::Solid(tree), false});
  }

  // By the combine of the list; the whole has the name and the slot that it had.
  static NodePtr joined(const Node& whole, const NodePtr& left, Operation operation,
                        const NodePtr& right, bool apart) {
    modeler::Lsu solids;
    solids.apply({{0, nullptr, entry("l", left)}, {1, nullptr, entry("r", right)}});
    try {
      const auto changes = modeler::combine(solids, "w", "l", operation, "r", apart);
      const NodePtr renamed = modeler::renamed(*changes.front().after->solid.tree(), whole.name);
      return modeler::renumbered(*renamed, whole.slot);
    } catch (const modeler::CommandError&) {
      return nullptr;
    }
  }

  static NodePtr repainted(const NodePtr& tree, const std::vector<std::string>& numbers) {
    if (const auto* primitive = tree->primitive()) {
      std::vector<std::int64_t> surfaces;
      for (const std::string& number : numbers) surfaces.push_back(std::stoll(number));
      auto result = *modeler::create({}, "p", primitive->kind, surfaces)
                         .front()
                         .after->solid.tree()
                         ->primitive();
      result.local_cena = primitive->local_cena;
      return modeler::make_node(tree->name, result, tree->slot);
    }
    const auto& composite = *tree->composite();
    return modeler::make_node(
        tree->name,
        modeler::Composite{composite.operation, repainted(composite.left, numbers),
                           repainted(composite.right, numbers)},
        tree->slot);
  }

  // A solid in a list of its own.
  static NodePtr done_alone(const NodePtr& tree, const std::string& command,
                            const std::string& rest) {
    const TempFolder folder;
    folder.write("part.CSG", csg_text(modeler::to_csg(*tree)));
    modeler::Interpreter session;
    session.execute("load x " + (folder / "part").string());
    session.execute("label x " + modeler::as_word(tree->name));
    try {
      session.execute(command + " x" + rest);
    } catch (const modeler::CommandError&) {
      return nullptr;
    }
    return with_slots(session.solids().find("x")->solid.tree(), *tree);
  }
  // A file may number its nodes otherwise.
  static NodePtr with_slots(const NodePtr& tree, const Node& as) {
    if (const auto* primitive = tree->primitive())
      return modeler::make_node(tree->name, *primitive, as.slot);
    const auto& composite = *tree->composite();
    return modeler::make_node(
        tree->name,
        modeler::Composite{composite.operation, with_slots(composite.left, *as.composite()->left),
                           with_slots(composite.right, *as.composite()->right)},
        as.slot);
  }
};

}  // namespace sir::test

// A scene as the four files describe it: plain data in double (BASICO, 3.3.1).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include <glm/mat3x3.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "tracer/intersect.h"

namespace sir {

/// UNIAO, DIFERENCA, INTERSECAO (thesis 2.3.1).
enum class Operation : std::uint8_t { union_of, difference, intersection };

/// LOCAL_CENA in the layout of Transform: column i of `linear` is line i of the
/// file, `translation` its fourth line.
struct Placement {
  glm::dmat3 linear{1.0};
  glm::dvec3 translation{0.0};
};

/// One node of the CSG tree. A composite has `left` and `right`, indices into
/// CsgTree::nodes; a primitive the rest.
struct CsgNode {
  std::int64_t number = 0;
  std::string name;
  bool composite = false;
  Operation operation = Operation::union_of;
  PrimitiveKind kind = PrimitiveKind::cube;
  bool surface_per_face = false;  ///< written in the file one per face
  std::size_t left = 0, right = 0;
  std::array<std::int64_t, 6> surfaces{};  ///< surface number of each face
  Placement placement;
  std::size_t line = 0;           ///< where the node stands in its file; 0: in none
  std::size_t surfaces_line = 0;  ///< where its surface numbers stand
};

/// The tree of composition (fig. 2.5), in the file's order. It may be a chain
/// of any depth: nothing walks it by recursion.
struct CsgTree {
  std::vector<CsgNode> nodes;
  std::size_t root = 0;
};

/// Nodes on the longest way from the root to a primitive, both counted; found without
/// recursion.
std::size_t depth_of(const CsgTree& tree);

/// The camera file (3.6.2), in SC_CENA.
struct CameraFile {
  glm::dvec2 window{4, 3};  ///< width, height
  glm::dvec3 target{0};
  glm::dvec3 normal{0, 0, -1};  ///< from the camera towards the scene
  double distance = 1;          ///< from the screen's centre to the target
  glm::dvec3 up{0, 1, 0};
  bool parallel = false;
  double focal = 1;  ///< Zf; equals `distance` where the file has no sixth line
  bool focal_given = false;
};

/// A point light; 1 is full intensity of a primary.
struct Light {
  glm::dvec3 position{0};
  glm::dvec3 intensity{1};
};

/// The light file (3.6.3).
struct Lighting {
  glm::dvec3 background{0};
  glm::dvec3 ambient{0};
  std::vector<Light> lights;
};

/// CAR_REF_LUZ_SUP (2.4.3): how a surface reflects and transmits light.
struct Coefficients {
  glm::dvec3 ambient{0};    ///< kar kag kab
  glm::dvec3 diffuse{0};    ///< kdr kdg kdb
  double specular = 0;      ///< ks
  double exponent = 0;      ///< n
  double transmission = 0;  ///< kt
  double index = 0;         ///< ir, refraction
};

/// LISA: one set of coefficients. XADREZ: a chequerboard of two (2.4.4).
enum class TextureKind : std::uint8_t { plain, chequer };

struct Surface {
  std::int64_t number = 0;
  std::string name;
  TextureKind texture = TextureKind::plain;
  Coefficients first, second;             ///< second: odd cells of XADREZ
  std::int64_t cells_u = 1, cells_v = 1;  ///< nu, nv of XADREZ
};

struct Scene {
  CsgTree tree;
  CameraFile camera;
  Lighting lighting;
  std::vector<Surface> surfaces;
};

}  // namespace sir

// The functions of the modeler that change the list of solids (thesis 3.2.2), apart from how they
// are asked for. Each says what would change and leaves the doing to History, so that one that is
// refused has changed nothing.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "modeler/lsu.h"

namespace sir::modeler {

/// All throw CommandError, one line, where the function cannot be done: a name that is unknown ("o
/// sólido não existe", with the nearest one that is known), taken ("o sólido já existe") or not
/// fit to be one, and what is said below.

/// Cria sólido primitivo (3.2.2.1) at its standard place in SC_LOCAL. `surfaces`: one number for
/// all faces, or one for each.
Changes create(const Lsu& solids, const std::string& name, PrimitiveKind kind,
               const std::vector<std::int64_t>& surfaces);

/// Changes a node of a solid in place (see modeler/edit.h); the place is in its tree. Scale and
/// rotation of a composite act about the centre of its bounds, all else about the origin of
/// SC_CENA.
Changes edit(const Lsu& solids, std::string_view name, Edit edit);

/// Transforma sólido (3.2.2.2): the same with a step for the whole solid, which is appended to
/// every LOCAL_CENA. Refuses what would make a matrix singular.
Changes transform(const Lsu& solids, std::string_view name, Step step);

/// Combina sólidos (3.2.2.3): both become parts of the new one. Refuses one solid twice and, but
/// where `apart` allows it, difference and intersection of solids whose bounds do not meet ("não há
/// interseção entre os sólidos").
Changes combine(const Lsu& solids, const std::string& name, std::string_view left,
                Operation operation, std::string_view right, bool apart = false);

/// Deleta sólido (3.2.2.4).
Changes erase(const Lsu& solids, std::string_view name);

/// Copia sólido (3.2.2.5), primitives too. Source and copy share what neither can change.
Changes copy(const Lsu& solids, std::string_view source, const std::string& destination);

/// Desfaz sólido (3.2.2.6): its two parts take its place, under the names of their nodes; a name
/// that is taken gets a number behind it. Refuses primitives ("o sólido não é composto").
Changes split(const Lsu& solids, std::string_view name);

/// Insere sólido na LSU: what Carrega sólido (3.2.2.8) does once the file is read. The root takes
/// the name.
Changes insert(const Lsu& solids, const std::string& name, const NodePtr& tree);

/// Another name in the list, and for the solid's root.
Changes rename(const Lsu& solids, std::string_view name, const std::string& new_name);

/// Another name for the root alone, which need not be the only one of this name: in the .CSG, where
/// names may repeat.
Changes label(const Lsu& solids, std::string_view name, const std::string& label);

/// The root's number, and perhaps its position, in the .CSG; see to_csg().
Changes number(const Lsu& solids, std::string_view name, FileSlot slot);

/// The solid of this name.
EntryPtr require(const Lsu& solids, std::string_view name);

/// `name` where it is free, else with a number behind it: "ball (2)", the lowest where none is left
/// out among those that are taken.
std::string free_name(const Lsu& solids, const std::string& name, std::string_view besides = {});

/// Refuses what the .CSG could not hold: nothing at all, white space at an end. So it is for a
/// label.
void require_label(std::string_view text);

/// The same, and control characters, which the .CSG may hold but no list should.
void require_name(std::string_view name);

}  // namespace sir::modeler

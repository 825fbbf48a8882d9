// The list of solids in use, LSU (thesis 3.2.1, 3.2.2).
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "modeler/solid.h"

namespace sir::modeler {

/// A solid under its name. Whether it has been saved says nothing of the solid: it may be noted at
/// any time.
struct Entry {
  std::string name;
  Solid solid;
  mutable bool saved = false;
};
using EntryPtr = std::shared_ptr<const Entry>;

/// A place in the list; places are never given twice.
using Place = std::uint64_t;

/// What a command does to the list: at a place, one solid for another; null: none. All of it can
/// be done the other way round.
struct Change {
  Place place;
  EntryPtr before, after;
};
using Changes = std::vector<Change>;

/// Solids by name, in the order in which they came. The thesis's list has a fixed number of places
/// ("não há espaço na LSU"); this one is as long as it must be.
class Lsu {
 public:
  /// existe_sólido_na_LSU, recupera_sólido_na_LSU: null where there is none of this name.
  EntryPtr find(std::string_view name) const;

  /// The place of a solid that is there.
  Place place_of(std::string_view name) const;

  bool empty() const { return entries_.empty(); }  ///< LSU_vazia
  std::size_t size() const { return entries_.size(); }

  /// All solids, by place.
  const std::map<Place, EntryPtr>& entries() const { return entries_; }

  /// A place that has never been given; and the one after the next `ahead`.
  Place free_place(Place ahead = 0) const { return next_ + ahead; }

  /// insere_sólido_na_LSU and libera_posição_na_LSU.
  void apply(const Changes& changes);
  void revert(const Changes& changes);

 private:
  struct Hash {
    using is_transparent = void;
    std::size_t operator()(std::string_view text) const {
      return std::hash<std::string_view>()(text);
    }
  };
  void remove(Place place, const Entry& entry);
  void put(Place place, const EntryPtr& entry);

  std::map<Place, EntryPtr> entries_;
  std::unordered_map<std::string, Place, Hash, std::equal_to<>> places_;
  Place next_ = 0;
};

}  // namespace sir::modeler

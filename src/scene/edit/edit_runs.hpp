#pragma once

#include <cstddef>
#include <span>
#include <stdexcept>
#include <utility>
#include <vector>

#include "scene/model/object.hpp"
#include "scene/model/shared_object.hpp"

/// How the changes of an edit act on lists: on those of a scene and on whatever runs parallel to them.
namespace sarsim::scene {

struct Edit;

/// One change, in the direction in which it is made: out without value inserts, in without value removes.
struct ListChange {
  ObjectId id;
  const SharedObject* out = nullptr;
  const SharedObject* in = nullptr;

  [[nodiscard]] bool inserts() const { return out == nullptr; }
  [[nodiscard]] bool removes() const { return in == nullptr; }
};

/// The changes of an edit in the order in which they are made. They point into the edit.
/// @throws std::logic_error for a change that neither takes nor gives an object
[[nodiscard]] std::vector<ListChange> list_changes(const Edit& edit, bool forwards);

/// How many of the first changes can be made to one list in one pass: removals in descending or insertions in ascending
/// order, replacements in either.
[[nodiscard]] std::size_t run_length(std::span<const ListChange> changes);

/// What a run of changes does to places in the list that it changes; those that are removed go. Ascending before and
/// after; takes time linear in both.
void move_places(std::vector<std::size_t>& places, std::span<const ListChange> run);

[[noreturn]] inline void throw_foreign_edit() {
  throw std::logic_error("edit: the scene is not the one that the edit was made for");
}

/// Makes a run of changes to a list, in time linear in both. All of `fits` is asked before anything is changed.
///
/// @param fits     (const Item&, const ListChange&): whether the item is the one that the change takes
/// @param replace  (Item&, const ListChange&): puts the new in place of the old
/// @param remove   (Item&&, const ListChange&): is handed what goes
/// @param insert   (const ListChange&) -> Item: makes what comes
/// @throws std::logic_error where the list has no such place or an item does not fit; the list is then unchanged
template <class Item, class Fits, class Replace, class Remove, class Insert>
void change_list(std::vector<Item>& list, std::span<const ListChange> run, Fits fits, Replace replace, Remove remove,
                 Insert insert) {
  const bool inserting = run.front().inserts();
  for (std::size_t i = 0; i < run.size(); ++i) {
    const std::size_t limit = inserting ? list.size() + i + 1 : list.size();
    if (run[i].id.index >= limit || (!inserting && !fits(list[run[i].id.index], run[i]))) throw_foreign_edit();
  }
  if (inserting) {
    // From the back: each item of the longer list is either the next new one or the next old one.
    std::size_t old = list.size();
    std::size_t added = run.size();
    list.resize(old + added);
    for (std::size_t at = list.size(); added > 0; --at) {
      if (run[added - 1].id.index == at - 1)
        list[at - 1] = insert(run[--added]);
      else
        list[at - 1] = std::move(list[--old]);
    }
  } else if (run.front().removes()) {
    std::size_t kept = run.back().id.index;
    std::size_t left = run.size();
    for (std::size_t at = kept; at < list.size(); ++at) {
      if (left > 0 && run[left - 1].id.index == at)
        remove(std::move(list[at]), run[--left]);
      else
        list[kept++] = std::move(list[at]);
    }
    list.resize(kept);
  } else {
    for (const ListChange& change : run) replace(list[change.id.index], change);
  }
}

}  // namespace sarsim::scene

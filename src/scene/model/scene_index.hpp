#pragma once

#include <cstddef>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::scene {

/// The names of a scene's platforms or radars, for looking many of them up: agrees with `find_platform` and
/// `find_radar` and says besides how a name was found.
class NameTable {
 public:
  /// How a name was found: as it is, as the beginning of the only one, of several, or not at all.
  enum class Match { exact, prefix, ambiguous, none };

  /// What a name stands for.
  struct Result {
    Match match = Match::none;
    std::size_t index = not_found;  ///< Where exact or prefix.
  };

  /// A table of names, which must outlive it, in the order of their definitions.
  explicit NameTable(std::vector<std::string_view> names);

  /// Looks a name up, without regard to case.
  [[nodiscard]] Result find(std::string_view name) const;
  /// The first defined names for which `name` could stand, for messages: "Plane, Planet".
  [[nodiscard]] std::string candidates(std::string_view name) const;
  /// Position of each name that was defined before, with the position of its first definition.
  [[nodiscard]] const std::vector<std::pair<std::size_t, std::size_t>>& duplicates() const { return duplicates_; }
  [[nodiscard]] const std::vector<std::string_view>& names() const { return names_; }

 private:
  [[nodiscard]] std::vector<std::size_t> sharing_prefix(std::string_view name, std::size_t most) const;

  std::vector<std::string_view> names_;
  std::map<std::string, std::size_t, std::less<>> first_;  // lower-case name -> its first definition
  std::set<std::size_t> lengths_;
  std::set<std::size_t> repeated_;  // first definitions of names that are defined again
  std::vector<std::pair<std::size_t, std::size_t>> duplicates_;
};

/// What the names in a scene mean, for code that asks for many of them: each is looked up once.
class SceneIndex {
 public:
  /// @param scene  must outlive the index and keep its platforms and radars
  explicit SceneIndex(const Scene& scene);
  SceneIndex(const SceneIndex&) = delete;
  SceneIndex& operator=(const SceneIndex&) = delete;

  /// As `find_platform` says.
  [[nodiscard]] std::size_t platform(std::string_view name) { return platforms_.find(name); }
  /// As `find_radar` says.
  [[nodiscard]] std::size_t radar(std::string_view name) { return radars_.find(name); }

 private:
  // Names of one kind of object, with what was asked before.
  class Names {
   public:
    Names(std::vector<std::string_view> names, bool with_world) : table_(std::move(names)), with_world_(with_world) {}
    std::size_t find(std::string_view name);

   private:
    [[nodiscard]] std::size_t look_up(std::string_view name) const;

    NameTable table_;
    bool with_world_;
    std::unordered_map<std::string, std::size_t> known_;               // scenes name one platform a million times,
    const std::pair<const std::string, std::size_t>* last_ = nullptr;  // most often the one named just before
  };

  Names platforms_;
  Names radars_;
};

}  // namespace sarsim::scene

#pragma once

#include <cstddef>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "scene/model/scene.hpp"

namespace sarsim::test {

/// Which fields and keywords of the language some scenes have used. What there is to be used is in the tables that
/// reader and writer work from, so that a field that is added there is missed here.
class FieldCover {
 public:
  FieldCover();

  /// Notes what a scene's script says.
  void note(const scene::Scene& scene);

  /// Fields of which fewer than two values, keywords and kinds of function blocks of which none has been seen, by name.
  [[nodiscard]] std::vector<std::string> missing() const;
  [[nodiscard]] std::size_t fields() const { return values_.size(); }
  [[nodiscard]] std::size_t keywords() const { return keywords_.size(); }
  [[nodiscard]] std::size_t blocks() const { return blocks_.size(); }

 private:
  void note_fields(const scene::Scene& scene, const std::string& text);
  void note_keywords(const std::string& text);
  void note_blocks(const scene::Scene& scene);

  std::map<std::pair<std::string, std::string>, std::set<std::string>> values_;  // (kind, member): words seen
  std::map<std::pair<std::string, std::string>, std::size_t> keywords_;          // (kind, keyword): times
  std::map<std::string, std::size_t> blocks_;  // "trajectory by CUBIC", "trajectory in a FILE": times
};

}  // namespace sarsim::test

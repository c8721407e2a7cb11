#pragma once

#include <map>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "scene/edit/edit.hpp"
#include "scene/script/data_file.hpp"

namespace sarsim::scene {

/// One user-defined function of an object, with its place in the script language.
struct FunctionUse {
  const FunctionBlock* block = nullptr;
  std::span<const core::SampledFunction> parts;
  const std::string* file = nullptr;  ///< Empty: INLINE.
};

/// All user-defined functions of an object, also of alternatives that are not chosen; as many for every object of a
/// kind, in the same order. They point into the object, which must outlive them.
[[nodiscard]] std::vector<FunctionUse> functions_of(const SharedObject& object);
std::vector<FunctionUse> functions_of(const SharedObject&& object) = delete;

/// Texts of data files that a scene speaks of but that have not been written yet.
///
/// A function that is edited keeps the name of its file; until that file is written, the data of the function are here.
class PendingData {
 public:
  /// Notes the data of functions that an edit gives new points or another file, as far as the file does not say the
  /// same already.
  void follow(const Edit& edit, bool forwards, const DataFileLoader& disk);

  /// Puts a text in place of what a file holds: of a file that the scene's text includes.
  void put(const std::string& name, std::string text) { texts_[name] = std::move(text); }

  /// Finds the pending data first, then what is on disk. Data that have come to stand on disk exactly are no longer
  /// pending.
  [[nodiscard]] DataFileLoader loader(DataFileLoader disk);

  /// File name, as the script gives it, and text of each.
  [[nodiscard]] const std::map<std::string, std::string>& texts() const { return texts_; }

 private:
  void note(const FunctionUse& function, const DataFileLoader& disk);

  std::map<std::string, std::string> texts_;
};

}  // namespace sarsim::scene

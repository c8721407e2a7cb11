#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace sarsim::scene {

/// A copy of an unsaved document that survives a crash: one file in a folder for each document that a running program
/// has open, holding the path of the document and its text. Programs never touch each other's: a file is named after
/// the number and the start of its process, so that one that gets the number of a dead one does not write over what
/// that left.
class Recovery {
 public:
  /// @param folder  is made with the first copy where it does not exist
  /// @param owner   number of the process that owns this copy
  /// @param number  tells the documents of a process apart
  explicit Recovery(const std::filesystem::path& folder, long owner, int number = 0);

  /// Writes the copy, completely or not at all. Throws std::runtime_error.
  void keep(const std::filesystem::path& document, const std::string& text) const;
  /// Forgets it: the document was saved or closed.
  void forget() const;

  /// What a program left behind that ended without closing its document.
  struct Copy {
    std::filesystem::path file;      ///< The copy itself.
    std::filesystem::path document;  ///< Empty where it was never saved.
    std::string text;
  };
  /// Copies whose owners no longer run, newest first. Damaged ones are left out. Takes away what programs left that
  /// were killed while they wrote a copy.
  [[nodiscard]] static std::vector<Copy> orphans(const std::filesystem::path& folder);
  /// Takes a copy away.
  static void discard(const Copy& copy);

 private:
  long owner_;
  std::filesystem::path file_;
};

}  // namespace sarsim::scene

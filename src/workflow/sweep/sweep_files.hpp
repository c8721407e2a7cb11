#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "workflow/sweep/sweep_axes.hpp"
#include "workflow/sweep/sweep_request.hpp"
#include "workflow/sweep/sweep_row.hpp"

namespace sarsim::workflow {

/// The names of the files that a sweep makes.
class SweepFiles {
 public:
  /// Those of the part that a request is for.
  explicit SweepFiles(const SweepRequest& request);

  /// What the names of the tables and journals of all parts begin with.
  [[nodiscard]] const std::string& stem() const { return stem_; }
  /// The file of that name in the folder of the sweep.
  [[nodiscard]] std::filesystem::path beside(const std::string& name) const { return folder_ / name; }
  /// The table or journal of this part.
  /// @param extension  with its dot
  [[nodiscard]] std::filesystem::path of_part(const std::string& extension) const {
    return beside(part_stem_ + extension);
  }

 private:
  std::filesystem::path folder_;
  std::string stem_;
  std::string part_stem_;
};

/// Throws core::InvalidRequest where a file, or what is in the place of the folder, stands in the way of what a sweep
/// makes.
void expect_free_files(const SweepRequest& request, const Sweep& sweep, const std::vector<SweepRow>& rows);

}  // namespace sarsim::workflow

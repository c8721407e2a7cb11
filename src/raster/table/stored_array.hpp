#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include "core/report/problem.hpp"
#include "raster/table/sink.hpp"

namespace sarsim::raster {

/// An array that stands in a file as it is in memory: in one piece, the last index fastest, nothing compressed. Whoever
/// knows this needs no library of the file's format.
struct StoredArray {
  std::string name = {};                     ///< "samples", "pulse_time_s"; docs/formats/samples.md.
  std::string type = {};                     ///< As NumPy writes it: "<c8", "<i4".
  std::size_t item_bytes = 0;                ///< Of one number.
  std::vector<std::uint64_t> shape = {};     ///< At least one size.
  std::vector<std::string> dimensions = {};  ///< A name for each.
  std::uint64_t offset = 0;                  ///< Where it begins in the file.
  Facts facts = {};                          ///< Units and what else is said of it.
  std::vector<std::string> words = {};  ///< Letters that it holds instead of numbers; they stand nowhere in the file.
  std::vector<double> numbers = {};     ///< Numbers ("<f8") that stand nowhere in the file.

  /// Whether its content is here, not in the file.
  [[nodiscard]] bool is_here() const { return !words.empty() || !numbers.empty(); }
};

/// An axis whose numbers are computed: a name, one dimension of that name, and what they are.
[[nodiscard]] inline StoredArray axis_here(const std::string& name, std::vector<double> numbers, const char* units,
                                           const char* long_name) {
  StoredArray axis{.name = name, .type = "<f8", .item_bytes = 8, .shape = {numbers.size()}, .dimensions = {name}};
  axis.facts = {{"units", units}, {"long_name", long_name}};
  axis.numbers = std::move(numbers);
  return axis;
}

/// What the last dimension of pairs means.
[[nodiscard]] inline StoredArray pair_names() {
  return {.name = "iq", .type = "<U1", .item_bytes = 4, .shape = {2}, .dimensions = {"iq"}, .words = {"I", "Q"}};
}

/// All arrays of a file, the samples first; or why they cannot be told.
using StoredArrays = std::variant<std::vector<StoredArray>, core::Problem>;

}  // namespace sarsim::raster

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "signal/measure/image_quality.hpp"
#include "workflow/focus/measure.hpp"

namespace sarsim::picture {

/// The measured targets of an image as words, one unit for each column, and where to mark them.
struct TargetTable {
  /// A target of the table.
  struct Row {
    std::size_t target = 0;          ///< Its number in the script, from 1.
    signal::ImagePlace expected;     ///< Where the scene says that it is imaged.
    bool inside = false;             ///< That place is in the image, and it has echoes.
    bool found = false;              ///< A peak stands out of the noise there.
    std::vector<std::string> words;  ///< One for each column; empty where there is nothing to say.
    std::vector<double> values;      ///< The same for sorting; not a number where there is none.
  };
  std::vector<std::string> columns;   ///< Headings with units.
  std::vector<std::string> meanings;  ///< Of the columns, a sentence each.
  std::vector<Row> rows;
  std::string summary;  ///< "23 of 24 found, at most 0.02 m position error"
};

/// The table of a report: offsets are found minus expected, signed.
[[nodiscard]] TargetTable target_table(const workflow::MeasureReport& report);

/// The table with tabs between columns, for spreadsheets.
[[nodiscard]] std::string text_of(const TargetTable& table);

}  // namespace sarsim::picture

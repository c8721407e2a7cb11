#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/maths/sampled_function.hpp"
#include "core/report/problem.hpp"
#include "scene/schema/function_block.hpp"
#include "scene/script/table_file.hpp"

namespace sarsim::scene {

/// The bytes of a data file that a script names, or why there are none.
struct DataFileText {
  std::string path;     ///< Where it was found, for messages; empty where it was not.
  std::string text;     ///< All of its bytes.
  std::string failure;  ///< Why it could not be read and where it was looked for; empty where it could.
};

/// Finds the data file of a name as a script gives it. A function, so that scripts can be read without a disk.
using DataFileLoader = std::function<DataFileText(const std::string& name)>;

/// Reads a user-function data file: a text with, for each function of `block`, the number of points, then x and y of
/// each point; or a table with a row for each x, as text or as a NumPy array (`table_file.hpp`). A text that cannot be
/// read in the first way is read as a table. Separators and comments are those of a script; docs/formats/script.md.
/// Always gives `block.count` lists; where `problems` holds an error they are incomplete. The method of interpolation
/// is not part of the file.
///
/// y is scaled to the units of the scene (`FunctionBlock::y_shift`). Takes time linear in the text, never more memory
/// than a few times the text whatever the counts say.
[[nodiscard]] DataFileReading read_data_file(std::string_view text, const std::string& file_name,
                                             const FunctionBlock& block);

/// The text of a data file for the functions of `block`, with comments that name the axes and their units. Reading it
/// gives the same points, bit for bit. Points must be finite.
[[nodiscard]] std::string write_data_file(std::span<const core::SampledFunction> functions, const FunctionBlock& block);

namespace script {

class Reporter;
class Tokens;

/// Which function of which block is read, and for whom.
struct FunctionText {
  const FunctionBlock& block;
  std::size_t part;         ///< Position of the function in the block.
  std::string_view member;  ///< Of the scene's structure; empty for a data file.
  bool whole_file;          ///< In a data file: no keywords follow, and there must be at least one point.
};

/// How the reading of points ended.
enum class PointsEnd {
  complete,
  keyword,  ///< A keyword stands where a number should; reported.
  broken,   ///< Reported, and what follows cannot be made sense of.
};

/// Reads the number of points and the points of one function.
[[nodiscard]] PointsEnd read_points(Tokens& tokens, const FunctionText& text, Reporter& reporter,
                                    std::vector<core::Knot>& points);

/// "position x (m) against time (s)".
[[nodiscard]] std::string axes_text(const FunctionBlock& block, std::size_t part);

/// Adds one point to a text: "x, y" in the units of a script.
void append_point(std::string& text, const FunctionBlock& block, const core::Knot& point);

}  // namespace script

}  // namespace sarsim::scene

#pragma once

#include <string>

#include "workflow/options/option_table.hpp"
#include "workflow/sweep/sweep_request.hpp"

namespace sarsim::workflow {

/// Reads "2/4" and throws core::InvalidRequest for anything else; nothing is the whole.
[[nodiscard]] SweepPart read_part(const std::string& text);

/// What is made of each recording besides, in words.
struct PostProcessingLabels {
  bool focus = false;
  bool search = false;
  bool profiles = false;
  bool measure = false;
  std::string with{};  ///< Options of what follows up.
};

/// The follow-up that is asked for; throws core::InvalidRequest for more than one.
[[nodiscard]] PostProcessing post_processing_of(const PostProcessingLabels& given);

/// A sweep as words ask for it.
struct SweepWords {
  SweepRequest request;
  PostProcessingLabels post_processing;
};

/// The options that a sweep has in every face.
[[nodiscard]] OptionTable<SweepWords> common_sweep_options();

/// The same and --product, for faces other than the command, which names products without an option.
[[nodiscard]] OptionTable<SweepWords> sweep_option_table();

/// The sweep of a scene in memory that words ask for. Throws core::InvalidRequest with everything that is wrong with
/// them.
/// @param input  as it was read and changed; its data files are read
[[nodiscard]] SweepRequest sweep_request(const SceneInput& input, const GivenWords& given);

}  // namespace sarsim::workflow

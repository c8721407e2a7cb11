#pragma once

#include <array>
#include <string>

#include "workflow/focus/focus_request.hpp"
#include "workflow/options/option_table.hpp"

namespace sarsim::workflow {

/// Every option of `focus`.
[[nodiscard]] OptionTable<FocusRequest> focus_option_table();

/// What an input and words for options ask for; the image is named after the input where they do not name it. Throws
/// core::InvalidRequest for the first word that means nothing.
[[nodiscard]] FocusRequest focus_request(const std::string& input, const GivenWords& given);

/// The words of --window without their parameters, for lists: each means its usual ones.
inline constexpr std::array window_words{"rectangular", "hamming", "hann", "kaiser", "taylor", "bartlett", "blackman"};

}  // namespace sarsim::workflow

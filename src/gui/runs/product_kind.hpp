#pragma once

#include <functional>
#include <span>
#include <string>
#include <vector>

#include "gui/runs/product_job.hpp"
#include "workflow/options/option.hpp"

namespace sarsim::gui {

/// Something to look at that is made of echoes, and its most important choice.
struct ProductKind {
  const char* command;  ///< As the command line calls it.
  const char* title;    ///< To be translated, as `option_title`.
  const char* option;
  const char* option_title;
  std::vector<const char*> values;                         ///< Of that option, the usual one first.
  std::function<std::vector<workflow::Option>()> options;  ///< All that the request takes.
  /// The work of a request; throws core::InvalidRequest for words that mean nothing.
  std::function<ProductJob::Work(const std::string& script, const workflow::GivenWords& words)> work;
};

/// The kinds of products, as a list shows them.
[[nodiscard]] std::span<const ProductKind> product_kinds();

}  // namespace sarsim::gui

#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "cli/command/commands.hpp"
#include "cli/shell/options.hpp"
#include "cli/shell/request_options.hpp"
#include "cli/shell/watch.hpp"
#include "workflow/product/products.hpp"

/// What the commands that make a product of echoes have in common.
namespace sarsim::cli {

/// What people read of a report.
struct ProductText {
  std::string summary;   ///< On standard error.
  std::string tables{};  ///< On standard output, where no JSON is asked for.
};

/// Prints a report: what people read, and JSON where asked for. Throws like `write_out`.
void print_product(Streams& streams, const RequestArguments& arguments, const ProductText& text,
                   const core::Facts& facts);

/// Adds the options of a product, its examples and the usual help for its input.
/// @param text_of  what people read of a report and its request
template <class Request, class Report>
Action add_product(CLI::App& app, const workflow::Product<Request, Report>& product,
                   const std::vector<std::pair<std::string, std::string>>& examples,
                   ProductText (*text_of)(const Report&, const Request&),
                   const std::string& input = "scene to simulate, or file of samples") {
  auto arguments = std::make_shared<RequestArguments>();
  add_request_arguments(app, product.options().options(), *arguments, input);
  add_examples(app, examples);
  return [arguments, product, text_of](Streams& streams) {
    Watch watch(streams, arguments->quiet);
    const Request request = product.request(arguments->input, arguments->given());
    const Report report = product.make(request, watch.observer());
    watch.close();
    const ProductText text = arguments->quiet ? ProductText{} : text_of(report, request);
    print_product(streams, *arguments, text, workflow::facts_of(report));
    return exit_done;
  };
}

}  // namespace sarsim::cli

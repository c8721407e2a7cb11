#include "cli/command/product_command.hpp"

namespace sarsim::cli {

void print_product(Streams& streams, const RequestArguments& arguments, const ProductText& text,
                   const core::Facts& facts) {
  if (!text.summary.empty()) write_err(streams, text.summary);
  if (arguments.json)
    write_out(streams, core::json_of(facts));
  else if (!text.tables.empty())
    write_out(streams, text.tables);
  else
    return;
  flush_out(streams);
}

}  // namespace sarsim::cli

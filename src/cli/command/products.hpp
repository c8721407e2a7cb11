#pragma once

#include "workflow/record/products.hpp"

namespace sarsim::cli {

using workflow::chosen_products;
using workflow::ProductJob;

}  // namespace sarsim::cli

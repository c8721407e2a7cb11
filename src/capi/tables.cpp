// The tables of sarsim.h.

#include "capi/tables.hpp"

#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "capi/call.hpp"
#include "core/text/json.hpp"
#include "core/text/number_text.hpp"

using namespace sarsim;

namespace {

double number_in_cell(const std::string& cell) {
  return core::parse_number(cell).value_or(std::numeric_limits<double>::quiet_NaN());
}

bool is_number_column(const core::CsvTable& table, std::size_t column) {
  for (const auto& row : table.rows)
    if (!row[column].empty() && !core::parse_number(row[column])) return false;
  return true;
}

}  // namespace

namespace sarsim::capi {

sarsim_table* table_handle(std::string csv) {
  auto made = std::make_unique<sarsim_table>();
  made->csv = core::valid_utf8(csv);
  made->table = core::read_csv(made->csv);
  for (std::size_t c = 0; c < made->table.names.size(); ++c) made->numbers.push_back(is_number_column(made->table, c));
  return made.release();
}

}  // namespace sarsim::capi

void sarsim_table_free(sarsim_table* table) { delete table; }
size_t sarsim_table_rows(const sarsim_table* table) { return table != nullptr ? table->table.rows.size() : 0; }
size_t sarsim_table_columns(const sarsim_table* table) { return table != nullptr ? table->table.names.size() : 0; }

const char* sarsim_table_name(const sarsim_table* table, size_t column) {
  return column < sarsim_table_columns(table) ? table->table.names[column].c_str() : "";
}

int sarsim_table_is_number(const sarsim_table* table, size_t column) {
  return column < sarsim_table_columns(table) && table->numbers[column] ? 1 : 0;
}

sarsim_status sarsim_table_numbers(const sarsim_table* table, size_t column, double* values,
                                   sarsim_problems** problems) {
  return capi::call(problems, [&](core::Problems&) {
    const core::CsvTable& known = capi::given(table, "sarsim_table_numbers: table").table;
    if (column >= known.names.size()) throw capi::BadArgument("sarsim_table_numbers: no such column");
    if (known.rows.empty()) return;
    double* next = &capi::given(values, "sarsim_table_numbers: values");
    for (const auto& row : known.rows) *next++ = number_in_cell(row[column]);
  });
}

const char* sarsim_table_text(const sarsim_table* table, size_t row, size_t column) {
  if (row >= sarsim_table_rows(table) || column >= sarsim_table_columns(table)) return "";
  return table->table.rows[row][column].c_str();
}

const char* sarsim_table_csv(const sarsim_table* table) { return table != nullptr ? table->csv.c_str() : ""; }

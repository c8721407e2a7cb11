#include "workflow/sweep/sweep_table.hpp"

#include <algorithm>
#include <cmath>
#include <set>
#include <string_view>

#include <fmt/format.h>

#include "core/build/version.hpp"
#include "core/text/csv.hpp"
#include "core/text/facts.hpp"
#include "core/text/number_text.hpp"
#include "core/text/problem_json.hpp"

namespace sarsim::workflow {

namespace {

const char* status_of(const SweepRow& row) { return row.done ? "done" : row.failure.empty() ? "not made" : "failed"; }

std::string product_name(const SweepFrame& frame, const SweepRow& row) {
  const workflow::ProductJob& job = frame.products->at(row.product);
  return fmt::format("{}{}", job.table ? "Geometry" : "Simulation", job.index + 1);
}

// A recording that was discarded has no size.
bool is_sized(const SweepRow& row) { return row.table || row.written; }

// The names of the figures of all rows, in the order in which they are met.
std::vector<std::string> figures_of(const std::vector<SweepRow>& rows) {
  std::vector<std::string> names;
  std::set<std::string_view> met;
  for (const SweepRow& row : rows)
    for (const SweepFigure& figure : row.figures)
      if (met.insert(figure.name).second) names.push_back(figure.name);
  return names;
}

void add_figures(std::string& line, const std::vector<std::string>& names, const SweepRow& row) {
  for (const std::string& name : names) {
    line += ',';
    const auto figure = std::ranges::find(row.figures, name, &SweepFigure::name);
    if (figure != row.figures.end() && std::isfinite(figure->value)) core::append_number(line, figure->value);
  }
}

constexpr std::string_view first_column = "variation,";
constexpr std::string_view product_columns = ",product,file,status,rows,columns,bytes,maximum_v,lsb_v,";

std::string heading_line(const SweepFrame& frame) {
  std::string line(first_column.substr(0, first_column.size() - 1));
  for (const SweepAxis& axis : frame.sweep->axes())
    line += fmt::format(
        ",{}", core::csv_cell(axis.unit().empty() ? axis.name : fmt::format("{} [{}]", axis.name, axis.unit())));
  line += product_columns;
  return line + "lsb_estimated,best_lsb_v,range_used,saturated,zero,engine,seconds";
}

std::string line_of(const SweepFrame& frame, const SweepRow& row) {
  std::string line = std::to_string(row.variation + 1);
  for (std::size_t i = 0; i < frame.sweep->axes().size(); ++i)
    line +=
        fmt::format(",{}", core::csv_cell(frame.sweep->axes()[i].table_text(frame.sweep->value_of(row.variation, i))));
  line += fmt::format(",{},{},{}", product_name(frame, row), core::csv_cell(row.file), status_of(row));
  if (!row.done) return line + std::string(12, ',');
  if (row.table) return line + fmt::format(",,,{},,,,,,,,,{:.6g}", core::format_number(row.bytes), row.seconds);
  const raster::RunReport& run = row.run;
  line +=
      fmt::format(",{},{},{}", run.rows, run.columns, is_sized(row) ? core::format_number(row.bytes) : std::string());
  line += fmt::format(",{},{},{}", core::format_number(run.maximum_v), core::format_number(run.lsb_v),
                      row.lsb_estimated ? 1 : 0);
  line += fmt::format(",{},{},{},{}", core::format_number(run.best_lsb_v), core::format_number(run.range_used),
                      run.saturated, run.zero);
  return line + fmt::format(",{},{:.6g}", row.engine, row.seconds);
}

void write_axes(core::JsonWriter& json, const Sweep& sweep) {
  json.key("axes").begin_array();
  for (const SweepAxis& axis : sweep.axes())
    json.begin_object()
        .member("name", axis.name)
        .member("field", axis.field.field->id)
        .member("unit", axis.unit())
        .member("values", axis.values.size())
        .end_object();
  json.end_array();
}

void write_values(core::JsonWriter& json, const Sweep& sweep, std::size_t variation) {
  json.key("values").begin_object();
  for (std::size_t i = 0; i < sweep.axes().size(); ++i) {
    const SweepAxis& axis = sweep.axes()[i];
    const std::size_t value = sweep.value_of(variation, i);
    json.key(axis.name).begin_object().member("text", axis.values[value]);
    if (const auto number = axis.is_number() ? core::parse_number(axis.table_text(value)) : std::nullopt; number)
      json.member("value", *number);
    json.end_object();
  }
  json.end_object();
}

void write_row(core::JsonWriter& json, const SweepFrame& frame, const SweepRow& row) {
  json.begin_object().member("variation", row.variation + 1);
  write_values(json, *frame.sweep, row.variation);
  json.member("kind", row.table ? "geometry" : "recording").member("product", product_name(frame, row));
  json.member("file", row.file).member("status", status_of(row));
  if (!row.failure.empty()) json.member("message", row.failure);
  if (row.done) {
    json.key("bytes");
    is_sized(row) ? json.value(row.bytes) : json.null();
    json.member("seconds", row.seconds);
  }
  if (!row.done && row.run.rows > 0)  // What a sweep that was only planned would make.
    json.member("rows", row.run.rows).member("columns", row.run.columns).member("bytes", row.bytes);
  if (row.done && !row.table) {
    const raster::RunReport& run = row.run;
    json.member("rows", run.rows).member("columns", run.columns).member("maximum_v", run.maximum_v);
    json.member("lsb_v", run.lsb_v).member("lsb_estimated", row.lsb_estimated).member("best_lsb_v", run.best_lsb_v);
    json.member("range_used", run.range_used).member("saturated", run.saturated).member("zero", run.zero);
    json.member("engine", row.engine);
  }
  if (!row.figures.empty()) {
    json.key("figures").begin_object();
    for (const SweepFigure& figure : row.figures) {
      json.key(figure.name);
      std::isfinite(figure.value) ? json.value(figure.value) : json.null();
    }
    json.end_object();
  }
  json.end_object();
}

}  // namespace

std::string sweep_csv(const SweepFrame& frame, const std::vector<SweepRow>& rows) {
  const std::vector<std::string> figures = figures_of(rows);
  std::string text = heading_line(frame);
  for (const std::string& name : figures) text += "," + name;
  text += '\n';
  for (const SweepRow& row : rows) {
    text += line_of(frame, row);
    add_figures(text, figures, row);
    text += '\n';
  }
  return text;
}

bool begins_as_sweep_csv(std::string_view beginning) {
  const std::string_view line = beginning.substr(0, beginning.find('\n'));
  return line.starts_with(first_column) && line.find(product_columns) != std::string_view::npos;
}

bool begins_as_sweep_json(std::string_view beginning) {
  std::size_t place = 0;
  for (const std::string_view member :
       {"{\n  \"sarsim\": \"", "\n  \"script\": \"", "\n  \"variations\": ", "\n  \"axes\": ["}) {
    const std::size_t found = beginning.find(member, place);
    if (found == std::string_view::npos || (place == 0 && found != 0)) return false;
    place = found + member.size();
  }
  return true;
}

std::string sweep_json(const SweepFrame& frame, const std::vector<SweepRow>& rows) {
  core::JsonWriter json;
  json.begin_object().member("sarsim", core::program_version).member("script", frame.script);
  json.member("variations", frame.sweep->size());
  write_axes(json, *frame.sweep);
  json.key("rows").begin_array();
  for (const SweepRow& row : rows) write_row(json, frame, row);
  json.end_array().member("status", frame.status).key("problems");
  write_json(json, *frame.problems);
  return json.end_object().text();
}

}  // namespace sarsim::workflow

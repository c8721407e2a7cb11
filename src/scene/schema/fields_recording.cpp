#include <charconv>

#include <fmt/format.h>

#include "scene/schema/field_table.hpp"
#include "scene/schema/scene_grammar.hpp"

namespace sarsim::scene::field_tables {

namespace {

constexpr std::string_view range_tip =
    "One-way slant range: c/2 times the delay. A pulse of length Tp covers c Tp/2 of it.";
constexpr std::string_view time_tip =
    "Azimuth (slow time): pulses sent from the start to the end are taken, both included.";

// A recording and a geometry table look through the same kind of window.
template <class Product, class Grammar>
void add_window(FieldTable<Product>& table, const Grammar& fields) {
  table.group("Window");
  table.number(fields.range_start, "Slant range from", Quantity::length, &Product::range_start_m,
               std::string(range_tip));
  table.number(fields.range_end, "Slant range to", Quantity::length, &Product::range_end_m, std::string(range_tip));
  table.number(fields.time_start, "Azimuth range from", Quantity::time, &Product::time_start_s, std::string(time_tip));
  table.number(fields.time_end, "Azimuth range to", Quantity::time, &Product::time_end_s, std::string(time_tip));
}

struct WindowGrammar {
  const script::Field& range_start;
  const script::Field& range_end;
  const script::Field& time_start;
  const script::Field& time_end;
};

void add_converter(FieldTable<Simulation>& table) {
  namespace grammar = script::simulation_grammar;
  table.group("A/D converter");
  table.number(grammar::sample_rate, "Sampling frequency", Quantity::frequency, &Simulation::sample_rate_hz,
               "Complex samples per second; at least the bandwidth of the pulse. Columns lie c/(2 fs) apart.");
  table.number(grammar::bits, "Number of bits", Quantity::count, &Simulation::bits,
               "Of I and of Q; counts reach from -(2^(bits-1) - 1) to 2^(bits-1).");
  table.number(grammar::lsb, "LSB value", Quantity::voltage, &Simulation::lsb_v,
               "Volts of one count. 0: estimated as the largest magnitude/(2^(bits-1) - 1).");
}

void add_product(FieldTable<Simulation>& table) {
  namespace grammar = script::simulation_grammar;
  table.group("File");
  table.choice("processing", "Processing", &Simulation::processing,
               {"Raw return", "Range compressed", "Synthetic range profile"},
               "Samples as received, through the matched filter, or range profiles from the steps of the carrier.");
  table.name(grammar::file, FieldKind::text, "File name", &Simulation::file,
             "Name of the file of samples, beside the script or in the folder of the run.");
  table.choice("format", "File type", &Simulation::format,
               {"ASCII, I Q", "Binary", "ASCII, (I,Q)", "HDF5", "CSV", "NumPy"},
               "How the file of samples is laid out; HDF5 carries its axes and the script.");
}

void add_pulse_choices(FieldTable<Simulation>& table) {
  namespace grammar = script::simulation_grammar;
  table.group("Pulse").rare();
  table.choice("pulse_position", "Pulse position", &Simulation::pulse_position, {"Start", "Centre"},
               "Whether a target's range is where its pulse starts or the centre of its pulse.");
  table.number(grammar::oversampling, "Over-sample", Quantity::number, &Simulation::oversampling,
               "Above 1 a band-limited pulse keeps only its nominal bandwidth.");
  table.number(grammar::width_factor, "New width", Quantity::number, &Simulation::width_factor,
               "Length of a band-limited pulse that is kept, in pulse widths.");
}

struct Column {
  std::string_view name;
  std::string_view label;
  int bit;
};
constexpr Column columns[] = {
    {"time", "Pulse transmit time (s)", 1},      {"frequency", "Pulse frequency (GHz)", 2},
    {"position", "Platform position (m)", 4},    {"velocity", "Platform velocity (m/s)", 8},
    {"rotation", "Platform rotation (deg)", 16}, {"delay", "Range delay (s)", 32},
    {"amplitude", "Return amplitude (V)", 64},   {"radial_speed", "Target radial velocity (m/s)", 128}};

void add_columns(FieldTable<GeometryTable>& table) {
  table.group("Columns");
  for (const Column& column : columns) {
    const unsigned bit = static_cast<unsigned>(column.bit);
    table.check_named(
        "columns." + std::string(column.name), std::string(column.label),
        [bit](const GeometryTable& t) { return (static_cast<unsigned>(t.columns) & bit) != 0; },
        [bit](GeometryTable& t, bool wanted) {
          const unsigned bits = static_cast<unsigned>(t.columns);
          t.columns = static_cast<int>(wanted ? bits | bit : bits & ~bit);
        },
        "A column of the table; platform columns repeat for every platform, the last three for every target.");
  }
}

// Seeds have 64 bits, more than a double holds.
Entry<RunOptions> seed_entry() {
  Entry<RunOptions> entry;
  entry.field.id = "seed";
  entry.field.label = "Seed";
  entry.field.tooltip =
      "Of all random numbers: the same seed gives the same noise and jitter. Takes 0 to 18446744073709551615.";
  entry.field.kind = FieldKind::quantity;
  entry.field.quantity = Quantity::count;
  entry.text = [](const RunOptions& options) { return std::to_string(options.seed); };
  entry.set = [](RunOptions& options, std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    if (first != std::string_view::npos) text = text.substr(first, text.find_last_not_of(" \t") - first + 1);
    std::uint64_t seed = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), seed);
    if (error != std::errc{} || end != text.data() + text.size())
      return fmt::format("'{}' is no seed; expected a whole number, 0 to 18446744073709551615", text.substr(0, 60));
    options.seed = seed;
    return std::string();
  };
  entry.reset = [](RunOptions& options) { options.seed = RunOptions{}.seed; };
  return entry;
}

}  // namespace

const FieldTable<Simulation>& simulation_table() {
  namespace grammar = script::simulation_grammar;
  static const FieldTable<Simulation> made = [] {
    FieldTable<Simulation> table;
    table.group("Simulation");
    table.name(grammar::radar, FieldKind::radar, "Radar", &Simulation::radar, "The radar whose echoes are recorded.");
    add_window(table, WindowGrammar{grammar::range_start, grammar::range_end, grammar::time_start, grammar::time_end});
    add_converter(table);
    add_product(table);
    add_pulse_choices(table);
    return table;
  }();
  return made;
}

const FieldTable<GeometryTable>& geometry_table() {
  namespace grammar = script::geometry_grammar;
  static const FieldTable<GeometryTable> made = [] {
    FieldTable<GeometryTable> table;
    table.group("Geometry");
    table.name(grammar::radar, FieldKind::radar, "Radar", &GeometryTable::radar, "The radar whose pulses are listed.");
    add_window(table, WindowGrammar{grammar::range_start, grammar::range_end, grammar::time_start, grammar::time_end});
    table.group("File");
    table.name(grammar::file, FieldKind::text, "File name", &GeometryTable::file,
               "Name of the table, beside the script or in the folder of the run.");
    table.choice("separator", "Separator", &GeometryTable::separator, {"Space", "Comma"},
                 "What stands between columns.");
    add_columns(table);
    return table;
  }();
  return made;
}

const FieldTable<RunOptions>& options_table() {
  namespace grammar = script::options_grammar;
  static const FieldTable<RunOptions> made = [] {
    FieldTable<RunOptions> table;
    table.group("Run options");
    table.choice("profile", "Profile", &RunOptions::profile, {"Physical", "Classic"},
                 "Conventions of radar engineering, or those of the programs of 1998 with their constants.");
    table.special(seed_entry());
    table.choice("pulse", "Pulse definition", &RunOptions::pulse, {"Ideal", "Band-limited"},
                 "Hard edges sampled where they are, or confined to the sampled band.");
    table.number(grammar::tolerance, "Tolerance", Quantity::number, &RunOptions::tolerance,
                 "Largest error of the echoes that a fast method may make, relative to the echo; 1e-12 to 0.1.");
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene::field_tables

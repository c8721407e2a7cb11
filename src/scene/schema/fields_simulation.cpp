#include "scene/schema/fields_window.hpp"

namespace sarsim::scene {

namespace {

void add_converter(FieldTable<Simulation>& table) {
  table.group("A/D converter");
  table.add<&Simulation::sample_rate_hz>(
      {.id = "sample_rate_hz",
       .key = "sample_rate",
       .label = "Sampling frequency",
       .words = "sampling frequency",
       .quantity = Quantity::frequency,
       .script_unit = "GHz",
       .range = above_zero,
       .likely = {1e3, 1e11},
       .tip = "Complex samples per second; at least the bandwidth of the pulse. Columns lie c/(2 fs) apart."});
  table.add<&Simulation::bits>({.id = "bits",
                                .key = "bits",
                                .label = "Number of bits",
                                .words = "bits of the A/D converter",
                                .noun = "number of A/D bits",
                                .quantity = Quantity::count,
                                .range = {1.0, 64.0},
                                .tip = "Bits per I and Q channel; counts range from -(2^(bits-1) - 1) to 2^(bits-1)."});
  table.add<&Simulation::lsb_v>({.id = "lsb_v",
                                 .key = "lsb",
                                 .label = "LSB value",
                                 .words = "value of the least significant bit",
                                 .quantity = Quantity::voltage,
                                 .script_unit = "mV",
                                 .usable = zero_or_more,
                                 .likely = {0.0, 1e3},
                                 .tip = "Volts of one count. 0: estimated as the largest magnitude/(2^(bits-1) - 1).",
                                 .detail = "0 = estimated"});
}

void add_product(FieldTable<Simulation>& table) {
  table.group("File");
  table.add<&Simulation::processing>(
      {.id = "processing",
       .key = "processing",
       .label = "Processing",
       .words = "processing",
       .choices = {{"RAW", Processing::raw, "Raw return", "samples as received"},
                   {"MATCHED_FILTER", Processing::matched_filter, "Range compressed", "compressed in range"},
                   {"SRP", Processing::srp, "Synthetic range profile", "synthetic range profiles of stepped carriers"}},
       .tip = "Samples as received, through the matched filter, or range profiles from the steps of the carrier."});
  table.add<&Simulation::file>({.id = "file",
                                .key = "file",
                                .label = "File name",
                                .words = "name of the output file",
                                .tip = "Name of the file of samples, beside the script or in the folder of the run."});
  table.add<&Simulation::format>(
      {.id = "format",
       .key = "format",
       .label = "File type",
       .words = "file format",
       .choices = {{"ASCII", FileFormat::ascii, "ASCII, I Q", "text, a line for each sample: I Q"},
                   {"BINARY", FileFormat::binary, "Binary", "unsigned little-endian integers"},
                   {"BRACKET", FileFormat::bracket, "ASCII, (I,Q)", "text, a line for each pulse: (I,Q)"},
                   {"HDF5", FileFormat::hdf5, "HDF5", "HDF5 file"},
                   {"CSV", FileFormat::csv, "CSV", "text, a line for each pulse: I,Q"},
                   {"NPY", FileFormat::npy, "NumPy", "NumPy array"},
                   {"ZARR", FileFormat::zarr, "Zarr", "Zarr store: a folder of files"},
                   {"SIGMF", FileFormat::sigmf, "SigMF", "SigMF recording: samples, and JSON about them"}},
       .tip = "How the file of samples is laid out; HDF5, Zarr and SigMF carry their axes and the script."});
}

void add_pulse_choices(FieldTable<Simulation>& table) {
  table.group("Pulse");
  table.add<&Simulation::pulse_position>(
      {.id = "pulse_position",
       .key = "pulse_position",
       .label = "Pulse position",
       .words = "place of a target within its pulse",
       .choices = {{"BEGIN", Simulation::PulsePosition::begin, "Start", "a target's range is where its pulse begins"},
                   {"CENTRE", Simulation::PulsePosition::centre, "Centre",
                    "a target's range is the centre of its pulse"}},
       .tip = "Which part of the echo is placed at the target's range: its leading edge or its centre.",
       .rare = true});
  table.add<&Simulation::oversampling>({.id = "oversampling",
                                        .key = "oversampling",
                                        .label = "Over-sample",
                                        .words = "pulse over-sampling factor",
                                        .noun = "over-sampling factor",
                                        .range = {1.0, 100.0},
                                        .tip = "Above 1 a band-limited pulse keeps only its nominal bandwidth.",
                                        .detail = "above 1 a band-limited pulse keeps its own band only",
                                        .rare = true});
  table.add<&Simulation::width_factor>({.id = "width_factor",
                                        .key = "width_factor",
                                        .label = "New width",
                                        .words = "kept length of a band-limited pulse in pulse widths",
                                        .noun = "pulse width factor",
                                        .range = {0.0, 100.0},
                                        .tip = "Length of the band-limited pulse that is kept, in pulse widths, 1 or "
                                               "more; 0 keeps all of it (in the classic profile: 1).",
                                        .detail = "0 keeps all of it (classic: 1)",
                                        .rare = true});
}

}  // namespace

template <>
const FieldTable<Simulation>& table_of<Simulation>() {
  static const FieldTable<Simulation> made = [] {
    FieldTable<Simulation> table;
    table.group("Simulation");
    table.add<&Simulation::radar>({.id = "radar",
                                   .key = "radar",
                                   .label = "Radar",
                                   .words = "name of the radar",
                                   .refers = "radar",
                                   .tip = "The radar whose echoes are recorded."});
    add_window(table, {"slant range of the first sample", "slant range of the end"});
    add_converter(table);
    add_product(table);
    add_pulse_choices(table);
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

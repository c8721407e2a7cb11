#include "scene/schema/fields_window.hpp"

namespace sarsim::scene {

template <>
const FieldTable<GeometryTable>& table_of<GeometryTable>() {
  static const FieldTable<GeometryTable> made = [] {
    using Separator = GeometryTable::Separator;
    FieldTable<GeometryTable> table;
    table.group("Geometry");
    table.add<&GeometryTable::radar>({.id = "radar",
                                      .key = "radar",
                                      .label = "Radar",
                                      .words = "name of the radar",
                                      .refers = "radar",
                                      .tip = "The radar whose pulses are listed."});
    add_window(table, {"slant range of the start", "slant range of the end"});
    table.group("File");
    table.add<&GeometryTable::file>({.id = "file",
                                     .key = "file",
                                     .label = "File name",
                                     .words = "name of the output file",
                                     .tip = "Name of the table, beside the script or in the folder of the run."});
    table.add<&GeometryTable::separator>(
        {.id = "separator",
         .key = "separator",
         .label = "Separator",
         .words = "separator of columns",
         .choices = {{"SPACE", Separator::space, "Space", "columns separated by blanks"},
                     {"COMMA", Separator::comma, "Comma", "columns separated by commas"}},
         .tip = "Separator between columns."});
    table.group("Columns");
    table.add<&GeometryTable::columns>(
        {.id = "columns",
         .key = "columns",
         .words = "sum of the column bits",
         .range = {0.0, 255.0},
         .flags = {{"time", "Pulse transmit time (s)", 1},
                   {"frequency", "Pulse frequency (GHz)", 2},
                   {"position", "Platform position (m)", 4},
                   {"velocity", "Platform velocity (m/s)", 8},
                   {"rotation", "Platform rotation (deg)", 16},
                   {"delay", "Range delay (s)", 32},
                   {"amplitude", "Return amplitude (V)", 64},
                   {"radial_speed", "Target radial velocity (m/s)", 128}},
         .tip = "A column of the table; platform columns repeat for every platform, the last three for every target.",
         .detail = "1 time, 2 frequency, 4 position, 8 velocity, 16 rotation, 32 delay, 64 amplitude, "
                   "128 radial speed"});
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

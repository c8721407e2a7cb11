#include "scene/schema/field_table.hpp"

namespace sarsim::scene {

template <>
const FieldTable<RunOptions>& table_of<RunOptions>() {
  static const FieldTable<RunOptions> made = [] {
    FieldTable<RunOptions> table;
    table.group("Run options");
    table.add<&RunOptions::profile>(
        {.id = "profile",
         .key = "profile",
         .label = "Profile",
         .words = "profile",
         .choices = {{"CLASSIC", Profile::classic, "Classic", "conventions of the 1998 programs"},
                     {"PHYSICAL", Profile::physical, "Physical", "conventions of radar engineering"}},
         .tip = "Conventions of radar engineering, or those of the programs of 1998 with their constants."});
    table.add<&RunOptions::seed>({.id = "seed",
                                  .key = "seed",
                                  .label = "Seed",
                                  .words = "seed of the random numbers",
                                  .quantity = Quantity::count,
                                  .tip = "Seed of all random numbers: the same seed gives the same noise and jitter. "
                                         "Takes 0 to 18446744073709551615."});
    table.add<&RunOptions::pulse>(
        {.id = "pulse",
         .key = "pulse",
         .label = "Pulse definition",
         .words = "definition of the pulse",
         .choices = {{"IDEAL", PulseDefinition::ideal, "Ideal", "hard edges, sampled where they are"},
                     {"BAND_LIMITED", PulseDefinition::band_limited, "Band-limited", "confined to the sampled band"}},
         .tip = "Hard edges sampled where they are, or confined to the sampled band."});
    table.add<&RunOptions::tolerance>({.id = "tolerance",
                                       .key = "tolerance",
                                       .label = "Tolerance",
                                       .words = "tolerated relative error of the echoes",
                                       .noun = "tolerance",
                                       .range = above_zero,
                                       .usable = Range{1e-12, 0.1},
                                       .tip = "Largest error of a fast method, relative to the echo; 1e-12 to 0.1."});
    table.add<&RunOptions::cubic_ends>(
        {.id = "cubic_ends",
         .key = "cubic_ends",
         .label = "Spline end condition",
         .words = "rule for the ends of cubic functions",
         .choices = {{"CHORDS", core::CubicEnds::chords, "Chords", "slopes of the first and last chord, as since 1998"},
                     {"NOT_A_KNOT", core::CubicEnds::not_a_knot, "Not a knot",
                      "one cubic through the first three points and one through the last three"}},
         .tip = "End condition of CUBIC functions: the slope of the end chord, or not-a-knot, as orbits and other "
                "curved paths need."});
    table.add<&RunOptions::ambiguous_echoes>(
        {.id = "ambiguous_echoes",
         .key = "ambiguous_echoes",
         .label = "Range-ambiguous echoes",
         .words = "echoes of other pulses that a row receives",
         .choices = {{"STRONG", AmbiguousEchoes::strong, "Strong", "those above -60 dB of the strongest echo"},
                     {"ALL", AmbiguousEchoes::all, "All", "all that reach the window"},
                     {"NONE", AmbiguousEchoes::none, "None", "a row holds the echoes of its own pulse"}},
         .tip = "Range-ambiguous echoes: of pulses sent earlier or later, arriving within the range window. The "
                "classic profile never has them."});
    table.add<&RunOptions::eclipsing>(
        {.id = "eclipsing",
         .key = "eclipsing",
         .label = "Eclipsing",
         .words = "what the receiver does while the radar sends",
         .choices = {{"NONE", Eclipsing::none, "None", "the receiver goes on while the radar sends"},
                     {"BLANKED", Eclipsing::blanked, "Blanked", "samples are 0 while the radar sends"}},
         .tip = "Whether the receiver stays on or is blanked while the radar transmits."});
    return table;
  }();
  return made;
}

}  // namespace sarsim::scene

#pragma once

#include "comparisons/discrepancy/synthesis/synthesis_file.hpp"

namespace rebound {

/// Adds the effects that the file asks to be drawn to those that it names.
///
///   kind   each of those listed as likely as the others, none twice, none that the file names
///   size   null ± prior scale · 3^u, u even in [−1, 1]; a switch is on; below zero as often as
///          above, where the range has room
///
/// By the seed of the file, in a stream of its own: shots and noise are those of the same file with
/// these effects named.
/// Limit:  the same seed draws the same, another one another -> test RandomEffectsTest
/// Errors: Error(bad_input) with the key for a name that has no form in the tier, or for fewer
///         names than are to be drawn.
void draw_effects(const Document& document, SynthesisFile& file);

}  // namespace rebound

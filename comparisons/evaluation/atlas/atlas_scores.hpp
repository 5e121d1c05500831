#pragma once

#include "comparisons/evaluation/atlas/atlas.hpp"

namespace rebound {

/// Calibrates every law at every speed of a material and scores it at every
/// speed. What cannot be done says why in its cells.
void score_entry(AtlasEntry& entry);

}  // namespace rebound

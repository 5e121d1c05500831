#pragma once

#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/visitor.hpp"
#include "fem/interface/compression.hpp"

namespace rebound {

/// A whole compression file.
void describe(Visitor& visit, CompressionProblem& problem);

/// Reads a compression file, with every check that needs more than one value:
/// density, shares and terms of the material, travel against the radius, and
/// a duration where the path has one.
/// Errors: Error(bad_input) with file, line, key, value and what is allowed.
CompressionProblem read_compression(const Document& document);

}  // namespace rebound

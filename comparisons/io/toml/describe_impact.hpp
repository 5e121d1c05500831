#pragma once

#include "comparisons/io/toml/visitor.hpp"
#include "lumped/problem/impact.hpp"

namespace rebound {

/// The version of the file formats; every file starts with `schema = 1`.
void describe_schema(Visitor& visit);

void describe(Visitor& visit, Sphere& sphere);
void describe(Visitor& visit, Impact& impact);

}  // namespace rebound

#pragma once

#include "comparisons/io/toml/visitor.hpp"
#include "fem/interface/material.hpp"

namespace rebound {

void describe(Visitor& visit, PronyBranch& branch);
void describe(Visitor& visit, RadialLayer& layer);
void describe(Visitor& visit, Material& material);

}  // namespace rebound

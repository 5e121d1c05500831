#pragma once

#include "comparisons/config/visitor.hpp"
#include "lumped/problem/material.hpp"

namespace rebound {

void describe(Visitor& visit, PronyBranch& branch);
void describe(Visitor& visit, RadialLayer& layer);
void describe(Visitor& visit, Material& material);

}  // namespace rebound

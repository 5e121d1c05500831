#pragma once

#include <string>

#include "lumped/problem/modules.hpp"

namespace rebound {

/// The FE tier, loaded on first use from the folder of the program; it stays
/// loaded. Not to be called from two threads at once the first time.
///
/// Errors: Error(bad_input) in a program built without it (-DREBOUND_FEM=OFF);
/// Error(input_output_failed), naming the file and the loader's reason, when a
/// module that was built cannot be loaded.
const FemTier& fem_tier();

/// Was the program built with the FE tier?
bool has_fem_tier();

/// Where a module is looked for.
std::string module_file(const std::string& name);

}  // namespace rebound

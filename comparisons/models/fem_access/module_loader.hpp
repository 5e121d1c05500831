#pragma once

#include "fem/interface/modules.hpp"
#include "meshes/gmsh/interface.hpp"

namespace rebound {

/// The FE tier, loaded on first use from the folder of the program; it stays
/// loaded. Not to be called from two threads at once the first time.
///
/// Errors: Error(bad_input) in a program built without it (-DREBOUND_FEM=OFF);
/// Error(input_output_failed), naming the file and the loader's reason, when a
/// module that was built cannot be loaded.
const FemTier& fem_tier();

/// Gmsh, loaded as the FE tier is: reads a user's own mesh, makes unstructured ones, writes meshes.
/// Errors: the same.
const GmshModule& gmsh_module();

/// Was the program built with the FE tier?
bool has_fem_tier();

struct ModuleEntry {
  std::string file;
  const char* entry_point;  ///< an `extern "C"` function of the stamp
};

/// Loads a module for good and calls its entry point with the caller's stamp.
/// Errors: Error(input_output_failed), naming the file and the loader's reason, or
///         that the module's own stamp is another.
const void* open_module(const ModuleEntry& entry, unsigned long stamp);

}  // namespace rebound

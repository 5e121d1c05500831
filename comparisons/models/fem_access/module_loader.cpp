#include "comparisons/models/fem_access/module_loader.hpp"

#include <dlfcn.h>

#include "comparisons/models/fem_access/element_checks.hpp"
#include "comparisons/models/fem_access/material_laws.hpp"
#include "comparisons/models/installation.hpp"
#include "fem/interface/interface_stamp.hpp"  // generated
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

#ifdef REBOUND_HAS_FEM
constexpr bool built_with_fem = true;
#else
constexpr bool built_with_fem = false;
#endif

template <class Interface>
const Interface& load(const std::string& name, const char* entry_point) {
  if (!built_with_fem)
    throw Error(ExitCode::bad_input,
                "this program was built with -DREBOUND_FEM=OFF and has no module " + name +
                    "; build with -DREBOUND_FEM=ON to use the FE tier and mesh files");
  return *static_cast<const Interface*>(open_module(
      {.file = module_file(name).string(), .entry_point = entry_point}, interface_stamp));
}

}  // namespace

const void* open_module(const ModuleEntry& entry, unsigned long stamp) {
  const auto fail = [&](const char* reason) {
    throw Error(
        ExitCode::input_output_failed,
        std::string("the module cannot be loaded: ") + (reason ? reason : "no reason given"),
        {.file = entry.file});
  };
  // Lazily bound: deal.II brings two hundred libraries, of which a run calls little.
  void* library = dlopen(entry.file.c_str(), RTLD_LAZY | RTLD_LOCAL);
  if (!library) fail(dlerror());
  void* symbol = dlsym(library, entry.entry_point);
  if (!symbol) fail(dlerror());
  const void* interface = reinterpret_cast<const void* (*)(unsigned long)>(symbol)(stamp);
  if (!interface) fail("it was built from other sources than this program; build both again");
  return interface;
}

bool has_fem_tier() {
  return built_with_fem;
}

const FemTier& fem_tier() {
  static const FemTier& tier = load<FemTier>("rebound_fem", fem_entry_point);
  return tier;
}

const GmshModule& gmsh_module() {
  static const GmshModule& gmsh = load<GmshModule>("rebound_gmsh", gmsh_entry_point);
  return gmsh;
}

const ElementChecks& element_checks() {
  static const ElementChecks& checks =
      load<ElementChecks>("rebound_fem", element_checks_entry_point);
  return checks;
}

const MaterialLaws& material_laws() {
  static const MaterialLaws& laws = load<MaterialLaws>("rebound_fem", material_entry_point);
  return laws;
}

}  // namespace rebound

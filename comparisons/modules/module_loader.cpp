#include "comparisons/modules/module_loader.hpp"

#include <dlfcn.h>

#include <filesystem>
#include <system_error>

#include "comparisons/modules/element_checks.hpp"
#include "comparisons/modules/material_laws.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

#ifdef REBOUND_HAS_FEM
constexpr bool built_with_fem = true;
#else
constexpr bool built_with_fem = false;
#endif

/// Loads a module for good and calls its entry point.
template <class Interface>
const Interface& load(const std::string& name, const char* entry_point) {
  if (!built_with_fem)
    throw Error(ExitCode::bad_input,
                "this program was built with -DREBOUND_FEM=OFF and has no module " + name +
                    "; build with -DREBOUND_FEM=ON to use the FE tier");
  const std::string file = module_file(name);
  const auto fail = [&](const char* reason) {
    throw Error(ExitCode::input_output_failed,
                std::string("the module cannot be loaded: ") + (reason ? reason : "no reason given"),
                {.file = file});
  };
  void* library = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (!library) fail(dlerror());
  void* symbol = dlsym(library, entry_point);
  if (!symbol) fail(dlerror());
  const auto entry = reinterpret_cast<const Interface* (*)(unsigned long)>(symbol);
  const Interface* interface = entry(interface_stamp);
  if (!interface) fail("it was built from other sources than this program; build both again");
  return *interface;
}

}  // namespace

bool has_fem_tier() { return built_with_fem; }

std::string module_file(const std::string& name) {
  std::error_code status;
  const auto program = std::filesystem::read_symlink("/proc/self/exe", status);
  if (status)
    throw Error(ExitCode::input_output_failed,
                "the program's own folder cannot be found: " + status.message());
  return (program.parent_path() / ("lib" + name + ".so")).string();
}

const FemTier& fem_tier() {
  static const FemTier& tier = load<FemTier>("rebound_fem", fem_entry_point);
  return tier;
}

const ElementChecks& element_checks() {
  static const ElementChecks& checks = load<ElementChecks>("rebound_fem", element_checks_entry_point);
  return checks;
}

const MaterialLaws& material_laws() {
  static const MaterialLaws& laws = load<MaterialLaws>("rebound_fem", material_entry_point);
  return laws;
}

}  // namespace rebound

#include "comparisons/python/binding.hpp"

namespace {

constexpr const char* module_docstring =
    "Rebound: reference models of a ball hitting a rigid plate, normal impact, no spin.\n\n"
    "    lumped, LumpedProblem, simulate_many   contact laws\n"
    "    fem                                    finite elements\n"
    "    laws, effects                          what there is to choose from\n"
    "    read_dataset                           measurements\n"
    "    synthesize, calibrate, diagnose        as the commands of these names\n\n"
    "Numbers are in SI. What is refused is an Error with file, line, key, value and allowed.";

}  // namespace

PYBIND11_MODULE(rebound_impact, module) {
  using namespace rebound::python;
  module.doc() = module_docstring;
  module.attr("__version__") = REBOUND_VERSION;
  declare_error(module);
  declare_cards(module);
  declare_datasets(module);
  declare_lumped(module);
  declare_fem(module);
  declare_inference(module);
  declare_interruption(module);
}

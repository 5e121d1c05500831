#include "fem/element_tests/element_checks.hpp"

#include "fem/element_tests/free_vibration.hpp"
#include "fem/element_tests/linear_contact.hpp"
#include "fem/element_tests/linear_statics.hpp"
#include "fem/element_tests/manufactured_solution.hpp"
#include "fem/element_tests/uniform_stretch.hpp"

namespace rebound::fem {
namespace {

class Checks final : public ElementChecks {
 public:
  FieldError manufactured_solution(const Mesh& mesh, CellKind cells) const override {
    return manufactured_error(mesh, cells);
  }
  std::vector<UniformStress> follow(const Mesh& mesh, CellKind cells, const Material& material,
                                    const StretchHistory& history) const override {
    return follow_stretches(mesh, cells, material, history);
  }
  FreeVibration free_vibration(const Mesh& mesh, CellKind cells, VibratingMass mass,
                               const VibratingSphere& sphere) const override {
    return fem::free_vibration(mesh, cells, mass, sphere);
  }
  double linear_contact_force(const Mesh& mesh, const LinearContact& contact) const override {
    return fem::linear_contact_force(mesh, contact);
  }
  LinearAnswer linear_statics(const Mesh& mesh, CellKind cells,
                              const LinearStatics& problem) const override {
    return fem::linear_statics(mesh, cells, problem);
  }
};

}  // namespace

const ElementChecks& element_checks() {
  static const Checks checks;
  return checks;
}

}  // namespace rebound::fem

#include <deal.II/base/config.h>

#include "fem/discretisation/discretisation.hpp"
#include "fem/schemes/explicit_impact.hpp"
#include "lumped/problem/modules.hpp"

namespace {

class ExplicitFemTier final : public rebound::FemTier {
 public:
  rebound::FemResult simulate(const rebound::FemProblem& problem, const rebound::Mesh& mesh,
                              const rebound::RunControl& control) const override {
    const auto body = rebound::fem::discretise(mesh, problem.sphere.mass);
    return rebound::fem::run_explicit_impact(body, problem, control);
  }
  std::string versions() const override {
    return std::string("deal.II ") + DEAL_II_PACKAGE_VERSION + ", kernel " +
           rebound::fem::choose_cell_kernel().name;
  }
};

}  // namespace

extern "C" const rebound::FemTier* rebound_fem_tier() {
  static const ExplicitFemTier tier;
  return &tier;
}

#include "fem/discretisation/discretisation.hpp"
#include "fem/element_tests/element_checks.hpp"
#include "fem/explicit/explicit_impact.hpp"
#include "fem/implicit/implicit_impact.hpp"
#include "fem/implicit/static_compression.hpp"
#include "fem/interface/interface_stamp.hpp"  // generated
#include "fem/interface/modules.hpp"
#include "fem/materials/uniaxial.hpp"
#include "lumped/problem/error.hpp"

namespace {

class PreparedBody final : public rebound::FemBody {
 public:
  PreparedBody(const rebound::Mesh& mesh, double mass)
      : mesh_(mesh), body_(rebound::fem::discretise(mesh, mass)), mass_(mass) {}

  rebound::FemResult simulate(const rebound::FemProblem& problem,
                              const rebound::RunControl& control) const override {
    if (problem.sphere.mass != mass_)
      throw rebound::Error(rebound::ExitCode::bad_input, "the body was prepared for another mass",
                           {.key = "sphere.mass"});
    if (problem.scheme == rebound::FemScheme::implicit_steps)
      return rebound::fem::run_implicit_impact(mesh_, problem, control);
    return rebound::fem::run_explicit_impact(body_, problem, control);
  }

 private:
  rebound::Mesh mesh_;
  rebound::fem::Discretisation body_;
  double mass_;
};

class LoadedFemTier final : public rebound::FemTier {
 public:
  std::shared_ptr<const rebound::FemBody> prepare(const rebound::Mesh& mesh,
                                                  double mass) const override {
    return std::make_shared<PreparedBody>(mesh, mass);
  }
  rebound::CompressionResult compress(const rebound::CompressionProblem& problem,
                                      const rebound::Mesh& mesh,
                                      const rebound::RunControl& control) const override {
    return rebound::fem::run_static_compression(mesh, problem, control);
  }
  std::string versions() const override {
    return std::string("deal.II ") + DEAL_II_PACKAGE_VERSION + ", kernel " +
           rebound::fem::choose_cell_kernel().name;
  }
};

class LoadedMaterialLaws final : public rebound::MaterialLaws {
 public:
  std::vector<rebound::UniaxialState> uniaxial(
      const rebound::Material& material, const std::vector<double>& stretches) const override {
    return rebound::fem::uniaxial_states(material, stretches);
  }
};

}  // namespace

extern "C" const rebound::MaterialLaws* rebound_material_laws(unsigned long stamp) {
  static const LoadedMaterialLaws laws;
  return stamp == rebound::interface_stamp ? &laws : nullptr;
}

extern "C" const rebound::ElementChecks* rebound_element_checks(unsigned long stamp) {
  return stamp == rebound::interface_stamp ? &rebound::fem::element_checks() : nullptr;
}

extern "C" const rebound::FemTier* rebound_fem_tier(unsigned long stamp) {
  static const LoadedFemTier tier;
  return stamp == rebound::interface_stamp ? &tier : nullptr;
}

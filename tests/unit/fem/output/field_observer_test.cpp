// Stress and energies that an observer finds, against closed forms and against
// what the kernels give the nodes.
#include "fem/output/field_observer.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/fem_cases.hpp"

namespace rebound::fem {
namespace {

using test::Random;

/// A body that is moved by hand, one step at a time, and observed.
class ObservedCase {
 public:
  ObservedCase(const Discretisation& body, const Material& material, const CellKernel& kernel,
               double step)
      : body_(body),
        constants_(viscoelastic_constants(material)),
        kernel_(kernel),
        cells_(body, constants_, kernel.width),
        prony_(constants_, step),
        observer_(body, cells_, kernel, constants_),
        step_(step),
        history_(cells_.make_history()),
        before_(2 * (body.position.size() + 1), 0.0),
        force_before_(before_) {}

  /// Moves to `u`; returns the cells there.
  std::vector<CellState> move(const std::vector<double>& u) {
    std::vector<double> velocity(u.size()), force(u.size(), 0.0);
    for (std::size_t i = 0; i < u.size(); ++i) velocity[i] = (u[i] - before_[i]) / step_;
    const CellMotion motion{.displacement = u.data(), .velocity = velocity.data()};
    observer_.see(prony_.data(), motion, history_);
    const auto states = observer_.cells(prony_.data(), motion, history_);
    kernel_.internal_forces(cells_.arrays(), prony_.data(), motion, history_.data(), force.data());
    stored = kernel_.stored_energy(cells_.arrays(), u.data(), history_.data());
    for (std::size_t i = 0; i < u.size(); ++i)
      work += 0.5 * (force[i] + force_before_[i]) * (u[i] - before_[i]);
    prony_.advance(step_);
    before_ = u;
    force_before_ = force;
    return states;
  }

  double work = 0.0;    ///< of the nodes' forces so far [J]
  double stored = 0.0;  ///< by the kernel [J]

 private:
  const Discretisation& body_;
  ViscoelasticConstants constants_;
  const CellKernel& kernel_;
  CellBatches cells_;
  PronySteps prony_;
  FieldObserver observer_;
  double step_;
  std::vector<double> history_, before_, force_before_;
};

template <class Density>
double integral(const std::vector<CellState>& cells, const Density& density) {
  double sum = 0.0;
  for (const CellState& cell : cells) sum += cell.volume * density(cell);
  return sum;
}

TEST(FieldObserverTest, UniaxialStretchHasTheClosedFormStress) {
  // σ = [μ (b − 1) + λ ln J]/J of a compressible neo-Hookean body, μ = 1 Pa, λ = 4 Pa.
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  ObservedCase body_case(body, test::unit_material(), choose_cell_kernel(), 1.0);
  constexpr double a = 1.1, b = 0.7, jacobian = a * a * b;
  const auto sigma = [&](double stretch) {
    return (stretch * stretch - 1.0 + 4.0 * std::log(jacobian)) / jacobian;
  };
  const double energy = 0.5 * (2.0 * a * a + b * b - 3.0 - 2.0 * std::log(jacobian)) +
                        2.0 * std::log(jacobian) * std::log(jacobian);
  for (const CellState& cell : body_case.move(test::stretched(body, a, b))) {
    EXPECT_NEAR(cell.cauchy.rr, sigma(a), 1e-12);
    EXPECT_NEAR(cell.cauchy.tt, sigma(a), 1e-12);
    EXPECT_NEAR(cell.cauchy.zz, sigma(b), 1e-12);
    EXPECT_NEAR(cell.cauchy.rz, 0.0, 1e-12);
    EXPECT_NEAR(cell.von_mises, std::abs(sigma(b) - sigma(a)), 1e-12);
    EXPECT_NEAR(cell.pressure, -(2.0 * sigma(a) + sigma(b)) / 3.0, 1e-12);
    EXPECT_NEAR(cell.stored, energy, 1e-12);
    EXPECT_EQ(cell.lost, 0.0);
  }
}

TEST(FieldObserverTest, ShearHasTheClosedFormStress) {
  // J σ = μ (F Fᵀ − 1) + λ ln J 1 with F_zr alone off the diagonal.
  Mesh mesh;
  mesh.vertices = {{2.0, 0.0}, {3.0, 0.0}, {3.0, 1.0}, {2.0, 1.0}};
  mesh.cells = {{0, 1, 2, 3}};
  mesh.contact_edges = {{0, 1}};
  const auto body = discretise(mesh, 1.0);
  ObservedCase body_case(body, test::unit_material(), choose_cell_kernel(), 1.0);
  std::vector<double> u(2 * (body.position.size() + 1), 0.0);
  constexpr double slip = 0.3, lift = 0.2;
  for (int node = 0; node < 4; ++node)
    u[2 * node + 1] = slip * (body.position[node][0] - 2.0) + lift * body.position[node][1];
  const CellState cell = body_case.move(u)[0];
  constexpr double jacobian = 1.0 + lift;
  EXPECT_NEAR(cell.cauchy.rz, slip / jacobian, 1e-13);
  EXPECT_NEAR(cell.cauchy.rr, 4.0 * std::log(jacobian) / jacobian, 1e-13);
  EXPECT_NEAR(cell.cauchy.zz,
              (slip * slip + jacobian * jacobian - 1.0 + 4.0 * std::log(jacobian)) / jacobian,
              1e-13);
}

struct Named {
  const char* name;
  Material material;
};

std::vector<Named> materials() {
  std::vector<Named> all;
  for (const auto elastic : test::elastic_models) {
    Material material = test::unit_material(elastic);
    material.branches = {{0.3, 0.4, Relaxes::all}, {0.1, 2.0, Relaxes::deviator}};
    all.push_back({"convolution", material});
  }
  Material split = test::unit_material();
  split.relaxation = Relaxation::multiplicative;
  split.branches = {{0.3, 0.4, Relaxes::all}, {0.2, 0.1, Relaxes::deviator, 0.4, 0.05}};
  all.push_back({"multiplicative", split});
  Material whole = test::unit_material();
  whole.branches = {{0.3, 0.4, Relaxes::all}, {0.2, 0.1, Relaxes::all, 0.3, 0.05}};
  whole.strain = {.stiffening = 1.0, .softening = 0.2, .densification = 3.0, .mullins = 0.3};
  whole.retardation_time = 0.01;
  whole.layers = {{.from = 0.5, .modulus_factor = 3.0}};
  all.push_back({"everything", whole});
  return all;
}

class ObservedMaterial : public ::testing::TestWithParam<Named> {};

TEST_P(ObservedMaterial, DensitiesIntegrateToWhatTheNodesFeel) {
  const auto body = discretise(test::distorted_cylinder(), 1.0);
  for (const char* name : {"baseline", "avx2", "avx512"}) {
    const CellKernel* kernel = find_cell_kernel(name);
    if (!kernel) continue;
    ObservedCase observed(body, GetParam().material, *kernel, 0.02);
    Random random(5);
    std::vector<double> from = test::stretched(body, 1.0, 1.0), to = from;
    double largest = 0.0;
    for (int step = 0; step < 40; ++step) {
      if (step % 10 == 0) {
        from = to;
        to = random.vector(from.size(), 0.03);
        for (const int node : body.axis_nodes) to[2 * node] = 0.0;
        to[to.size() - 1] = to[to.size() - 2] = 0.0;
      }
      std::vector<double> u(from.size());
      for (std::size_t i = 0; i < u.size(); ++i)
        u[i] = from[i] + (to[i] - from[i]) * 0.1 * (step % 10 + 1);
      const auto cells = observed.move(u);
      largest = std::max(largest, std::abs(observed.work));
      EXPECT_NEAR(integral(cells, [](const CellState& c) { return c.stored; }), observed.stored,
                  1e-12 * largest)
          << name << " " << step;
      EXPECT_NEAR(integral(cells, [](const CellState& c) { return c.stored + c.held + c.lost; }),
                  observed.work, 1e-12 * largest)
          << name << " " << step;
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Materials, ObservedMaterial, ::testing::ValuesIn(materials()),
                         [](const auto& instance) {
                           return instance.param.name + std::to_string(instance.index);
                         });

TEST(FieldObserverTest, LossIsNamedByWhatIsKnownOfTheBranches) {
  Material material = test::unit_material();
  EXPECT_EQ(loss_of(viscoelastic_constants(material)), Loss::none);
  material.retardation_time = 0.1;
  EXPECT_EQ(loss_of(viscoelastic_constants(material)), Loss::dissipated);
  material.branches = {{0.3, 0.4, Relaxes::all}};
  EXPECT_EQ(loss_of(viscoelastic_constants(material)), Loss::dissipated_or_held);
  material.relaxation = Relaxation::multiplicative;
  EXPECT_EQ(loss_of(viscoelastic_constants(material)), Loss::dissipated);
}

}  // namespace
}  // namespace rebound::fem

// One battery over every law of the list: what any contact law must satisfy.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "lumped/integration/simulate.hpp"
#include "lumped/laws/make_law.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

class LawBattery : public testing::TestWithParam<std::string> {
 protected:
  LumpedProblem problem_ = test::typical_problem(GetParam());
  AnyLaw law() const { return make_law(problem_.model, problem_.impact, problem_.sphere); }
  template <class F>
  void each_state(F&& check) const {
    for (double x : {1e-6, 1e-4, 1e-3, 5e-3})
      for (double v : {-15.0, -1.0, 0.0, 1.0, 15.0})
        std::visit([&](const auto& l) { check(l, x, v); }, law());
  }
};

std::string name_without_hyphens(const testing::TestParamInfo<std::string>& info) {
  std::string name = info.param;
  std::erase(name, '-');
  return name;
}

std::vector<std::string> law_names() {
  std::vector<std::string> names;
  for (const auto& card : all_laws()) names.push_back(card.name);
  return names;
}

TEST_P(LawBattery, RefusesBadParameters) {
  const double inf = std::numeric_limits<double>::infinity();
  for (const auto& parameter : find_law(GetParam()).parameters) {
    for (double bad : {std::nan(""), inf, -inf, 1e308, parameter.range.lowest - 1.0}) {
      LumpedProblem broken = problem_;
      broken.model.parameters[parameter.name] = bad;
      try {
        simulate_fast(broken);
        ADD_FAILURE() << parameter.name << " = " << bad << " was accepted";
      } catch (const Error& error) {
        EXPECT_EQ(error.code(), ExitCode::bad_input);
        EXPECT_EQ(error.location().key, "model." + parameter.name);
        EXPECT_FALSE(error.location().allowed.empty());
      }
    }
    LumpedProblem at_limit = problem_;
    at_limit.model.parameters[parameter.name] = parameter.range.lowest;
    if (!parameter.range.lowest_allowed) {
      EXPECT_THROW(simulate_fast(at_limit), Error) << parameter.name;
    }
  }
}

TEST_P(LawBattery, NamesAMissingParameter) {
  for (const auto& parameter : find_law(GetParam()).parameters) {
    if (parameter.default_value) continue;
    LumpedProblem broken = problem_;
    broken.model.parameters.erase(parameter.name);
    try {
      simulate_fast(broken);
      ADD_FAILURE() << "ran without " << parameter.name;
    } catch (const Error& error) {
      EXPECT_EQ(error.code(), ExitCode::bad_input);
      EXPECT_EQ(error.location().key, "model." + parameter.name);
    }
  }
}

TEST_P(LawBattery, TypicalParametersReturnWhatTheCardSays) {
  const double e = simulate_fast(problem_).scalars.restitution;
  EXPECT_GT(e, 0.4);
  EXPECT_LT(e, 0.8);
}

TEST_P(LawBattery, NoForceAtRest) {
  std::visit([](const auto& l) { EXPECT_EQ(l.force(0.0, 0.0), 0.0); }, law());
}

TEST_P(LawBattery, ForceIsElasticPlusDamping) {
  each_state([](const auto& l, double x, double v) {
    const double sum = l.elastic_force(x) + l.damping_force(x, v);
    EXPECT_NEAR(l.force(x, v), sum, 1e-12 * (std::abs(l.elastic_force(x)) + std::abs(sum)));
  });
}

TEST_P(LawBattery, RootFormIsTheForce) {
  each_state([](const auto& l, double x, double v) {
    for (double sign : {1.0, -1.0}) {
      const ForceSlopes f = l.at_root(sign * std::sqrt(x), v);
      const double size = std::abs(l.elastic_force(x)) + std::abs(l.damping_force(x, v));
      EXPECT_NEAR(f.force, l.force(sign * x, v), 1e-13 * size);
      EXPECT_NEAR(f.damping, l.damping_force(sign * x, v), 1e-13 * size);
    }
    EXPECT_EQ(l.at_root(0.0, v).force, l.force(0.0, v));
  });
}

// Fourth-order central differences of `force`; 1e-8 is their rounding at this spacing.
template <class F>
double central_difference(const F& f, double at, double h) {
  return (8.0 * (f(at + h) - f(at - h)) - (f(at + 2.0 * h) - f(at - 2.0 * h))) / (12.0 * h);
}

TEST_P(LawBattery, SlopesAreThoseOfTheForce) {
  each_state([](const auto& l, double x, double v) {
    const ForceSlopes f = l.at_root(std::sqrt(x), v);
    const double size = std::abs(l.elastic_force(x)) + std::abs(l.damping_force(x, 15.0));
    const double by_x = central_difference([&](double at) { return l.force(at, v); }, x, 1e-3 * x);
    EXPECT_NEAR(f.by_log_deflection, x * by_x, 1e-8 * size);
    const double by_v = central_difference([&](double at) { return l.force(x, at); }, v, 0.1);
    EXPECT_NEAR(f.by_speed, by_v, 1e-8 * size);
  });
}

TEST_P(LawBattery, ParameterSlopesAreThoseOfTheForce) {
  LumpedModel model = problem_.model;
  // Away from a corner of the table of coefficients.
  if (model.parameters.contains("poisson_ratio")) model.parameters["poisson_ratio"] = 0.37;
  const auto& cards = find_law(GetParam()).parameters;
  for (std::size_t i = 0; i < cards.size(); ++i) {
    const double value = model.parameters.at(cards[i].name);
    for (double x : {1e-4, 1e-3, 5e-3, 0.02})
      for (double v : {-15.0, 1.0, 15.0}) {
        const auto force_with = [&](double parameter) {
          LumpedModel changed = model;
          changed.parameters[cards[i].name] = parameter;
          return std::visit([&](const auto& l) { return l.force(x, v); },
                            make_law(changed, problem_.impact, problem_.sphere));
        };
        const double slope =
            std::visit([&](const auto& l) { return l.slope_by(i, std::sqrt(x), v); },
                       make_law(model, problem_.impact, problem_.sphere));
        const double size = std::abs(force_with(value)) / value;
        EXPECT_NEAR(slope, central_difference(force_with, value, 1e-3 * value), 1e-7 * size)
            << cards[i].name << " at x = " << x << ", v = " << v;
      }
  }
}

TEST_P(LawBattery, DampingNeverFeedsEnergy) {
  each_state([](const auto& l, double x, double v) { EXPECT_GE(l.damping_force(x, v) * v, 0.0); });
}

TEST_P(LawBattery, ElasticForceIsSlopeOfEnergy) {
  each_state([](const auto& l, double x, double) {
    // Fourth-order central difference; 1e-9 is its rounding at this spacing.
    const double h = 1e-3 * x;
    const auto e = [&](double at) { return l.elastic_energy(at); };
    const double slope =
        (8.0 * (e(x + h) - e(x - h)) - (e(x + 2.0 * h) - e(x - 2.0 * h))) / (12.0 * h);
    EXPECT_NEAR(slope / l.elastic_force(x), 1.0, 1e-9);
  });
}

TEST_P(LawBattery, PullsWhileOpeningBeyondZero) {
  std::visit(
      [](const auto& l) {
        EXPECT_LT(l.force(-1e-6, -5.0), 0.0);
        EXPECT_LT(l.force(-1e-4, -5.0), 0.0);
      },
      law());
}

TEST_P(LawBattery, ElasticLimitConservesEnergy) {
  problem_.model.parameters[test::loss_parameter(GetParam())] = 0.0;
  for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
    problem_.impact.separation = rule;
    EXPECT_NEAR(simulate_fast(problem_).scalars.restitution, 1.0, 1e-8);
    EXPECT_NEAR(simulate(problem_).scalars.restitution, 1.0, 1e-7);
  }
}

TEST_P(LawBattery, RestitutionFallsWithDampingAndStaysPositive) {
  const std::string loss = test::loss_parameter(GetParam());
  const double base = problem_.model.parameters.at(loss);
  double above = 1.0 + 1e-9;
  for (double factor : {0.0, 0.1, 0.3, 1.0, 3.0}) {
    problem_.model.parameters[loss] = factor * base;
    const double e = simulate_fast(problem_).scalars.restitution;
    EXPECT_GT(e, 0.0);
    EXPECT_LT(e, above) << "factor " << factor;
    above = e;
  }
}

TEST_P(LawBattery, EnergyBalanceCloses) {
  for (const auto rule : {SeparationRule::zero_force, SeparationRule::zero_deflection}) {
    problem_.impact.separation = rule;
    for (const auto& result : {simulate_fast(problem_), simulate(problem_)}) {
      // A thousand times the relative tolerance: local errors of some hundred steps.
      EXPECT_LE(result.closures.energy, 1e-6);
      EXPECT_LE(result.closures.impulse, 1e-6);
      // The samples see the same impulse, by their own trapezoid.
      const auto& t = result.trace;
      double sum = 0.0;
      for (std::size_t i = 1; i < t.time.size(); ++i)
        sum += 0.5 * (t.force[i] + t.force[i - 1]) * (t.time[i] - t.time[i - 1]);
      const double momentum =
          problem_.sphere.mass * (problem_.impact.speed + result.scalars.rebound_speed);
      EXPECT_NEAR(sum / momentum, 1.0, 5e-4);  // x^0.25 starts steeply
    }
  }
}

TEST_P(LawBattery, UnitsOnTheCardAreRight) {
  // Metres, seconds and kilograms replaced by other units must not change e:
  // every parameter scales with the dimension its card declares.
  const double kg = 7.0, m = 3.0, s = 0.2;
  const double before = simulate_fast(problem_).scalars.restitution;
  LumpedProblem scaled = problem_;
  for (const auto& parameter : find_law(GetParam()).parameters) {
    const Dimension d = parameter.dimension(problem_.model.parameters);
    scaled.model.parameters[parameter.name] *=
        std::pow(kg, d.kilogram) * std::pow(m, d.metre) * std::pow(s, d.second);
  }
  scaled.sphere.mass *= kg;
  scaled.impact.speed *= m / s;
  EXPECT_NEAR(simulate_fast(scaled).scalars.restitution, before, 1e-8);
}

TEST_P(LawBattery, SamplesSpanTheContact) {
  const LumpedResult result = simulate_fast(problem_);
  ASSERT_EQ(result.trace.time.size(), 401u);
  EXPECT_EQ(result.trace.time.front(), 0.0);
  EXPECT_EQ(result.trace.time.back(), result.scalars.contact_time);
  EXPECT_EQ(result.trace.deflection.front(), 0.0);
  const double step = result.scalars.contact_time / 400.0;
  for (std::size_t i = 1; i < 401; ++i)
    ASSERT_NEAR(result.trace.time[i] - result.trace.time[i - 1], step, 1e-12 * step * 400);
}

INSTANTIATE_TEST_SUITE_P(EveryLaw, LawBattery, testing::ValuesIn(law_names()),
                         name_without_hyphens);

}  // namespace
}  // namespace rebound

#include "comparisons/evaluation/benchmark/benchmark.hpp"

#include <gtest/gtest.h>

#include <cmath>

#include "comparisons/evaluation/benchmark/benchmark_file.hpp"
#include "comparisons/io/toml/file_errors.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/laws/laws.hpp"
#include "lumped/problem/error.hpp"
#include "tests/support/lumped_cases.hpp"

namespace rebound {
namespace {

MeasuredImpact reference_of(const LumpedProblem& problem) {
  const LumpedResult run = simulate(problem);
  return {.label = "reference",
          .sphere = problem.sphere,
          .impact = problem.impact,
          .trace = run.trace,
          .scalars = run.scalars};
}

BenchmarkEntry typical_entry(const std::string& law) {
  return {.label = law, .model = test::typical_problem(law).model};
}

TEST(BenchmarkTest, OwnTraceScoresZero) {
  for (const auto& card : all_laws()) {
    const auto problem = test::typical_problem(card.name);
    const auto matrix = benchmark({typical_entry(card.name)}, {reference_of(problem)});
    const auto& cell = matrix.cells[0][0];
    ASSERT_TRUE(cell.failure.empty());
    EXPECT_NEAR(*cell.against_reference.restitution, 0.0, 1e-6) << card.name;
    EXPECT_NEAR(*cell.against_reference.contact_time, 0.0, 1e-6) << card.name;
    EXPECT_NEAR(*cell.against_reference.contact_time_1pct, 0.0, 1e-3) << card.name;
    EXPECT_NEAR(*cell.against_reference.peak_force, 0.0, 1e-5) << card.name;
    EXPECT_NEAR(*cell.against_reference.peak_deflection, 0.0, 1e-5) << card.name;
    EXPECT_NEAR(*cell.against_reference.mean_deflection, 0.0, 1e-4) << card.name;
    // Linear between 401 samples; a force that starts like x^0.25 shows it.
    EXPECT_LT(cell.force_time_rms, 2e-3) << card.name;
    EXPECT_LT(cell.force_deflection_rms, 1e-3) << card.name;  // rounding at the tip
  }
}

// A spring against a spring 21 % stiffer: t_c ∝ κ^−½, F_m ∝ κ^½, x_m ∝ κ^−½,
// and a sine against a sine 10 % shorter and higher has a known misfit.
TEST(BenchmarkTest, ErrorsHaveTheirTextbookValues) {
  auto spring = [](double stiffness) {
    LumpedProblem problem = test::typical_problem("linear-kelvin-voigt");
    problem.model.parameters = {{"stiffness", stiffness}, {"damping", 0.0}};
    return problem;
  };
  const auto matrix = benchmark({{"stiffer", spring(1.21e5).model}}, {reference_of(spring(1e5))});
  const auto& cell = matrix.cells[0][0];
  EXPECT_NEAR(*cell.against_reference.peak_force, 0.1, 1e-5);
  EXPECT_NEAR(*cell.against_reference.peak_deflection, 1.0 / 1.1 - 1.0, 1e-5);
  EXPECT_NEAR(*cell.against_reference.contact_time, 1.0 / 1.1 - 1.0, 1e-7);
  EXPECT_NEAR(*cell.against_reference.restitution, 0.0, 1e-7);
  double sum = 0.0;  // half-sines of unit and 1.1 height, over the longer one
  const int n = 100000;
  for (int i = 0; i < n; ++i) {
    const double phase = M_PI * (i + 0.5) / n;
    const double other = 1.1 * phase < M_PI ? 1.1 * std::sin(1.1 * phase) : 0.0;
    sum += std::pow(other - std::sin(phase), 2);
  }
  EXPECT_NEAR(cell.force_time_rms, std::sqrt(sum / n), 1e-3);
  // At equal deflection F = κ x: 0.21 x up to the stiffer spring's x_m, beyond
  // it its turning force 1.1 stands against x.
  double loop = 0.0;
  for (int i = 0; i < n; ++i) {
    const double x = std::sin(M_PI * (i + 0.5) / n);
    loop += std::pow((x < 1.0 / 1.1 ? 1.21 * x : 1.1) - x, 2);
  }
  EXPECT_NEAR(cell.force_deflection_rms, std::sqrt(loop / n), 1e-3);
}

TEST(BenchmarkTest, ScoresAgainstMeasuredScalars) {
  auto reference = reference_of(test::typical_problem("hunt-crossley"));
  reference.restitution.value = 0.527;
  const auto matrix = benchmark({typical_entry("hunt-crossley")}, {reference});
  const auto& cell = matrix.cells[0][0];
  EXPECT_NEAR(*cell.against_measured.restitution, cell.scalars.restitution / 0.527 - 1.0, 1e-12);
  // The paper's λ for core A at 15 m/s returns 0.66, not the measured 0.527.
  EXPECT_NEAR(*cell.against_measured.restitution, 0.661 / 0.527 - 1.0, 2e-3);
  EXPECT_FALSE(cell.against_measured.contact_time.has_value());
}

TEST(BenchmarkTest, ALawWithoutAnswerKeepsItsCell) {
  auto per_speed = typical_entry("hunt-crossley");
  per_speed.model.parameters.erase("damping");
  per_speed.model.at_speed = {{5.0, {{"damping", 37.69e4}}}};
  const auto matrix = benchmark({per_speed, typical_entry("hertz-damped")},
                                {reference_of(test::typical_problem("hunt-crossley"))});
  ASSERT_EQ(matrix.cells.size(), 2u);
  EXPECT_NE(matrix.cells[0][0].failure.find("damping"), std::string::npos);
  EXPECT_FALSE(matrix.cells[0][0].against_reference.restitution.has_value());
  EXPECT_TRUE(matrix.cells[1][0].failure.empty());
}

TEST(BenchmarkTest, RefusesEmptyInput) {
  const auto reference = reference_of(test::typical_problem("hunt-crossley"));
  EXPECT_THROW(benchmark({}, {reference}), Error);
  EXPECT_THROW(benchmark({typical_entry("hunt-crossley")}, {}), Error);
  auto no_deflection = reference;
  no_deflection.trace.deflection.clear();
  EXPECT_THROW(benchmark({typical_entry("hunt-crossley")}, {no_deflection}), Error);
}

// Whether a row has a law of its own hangs on its file: where that was refused, no key is judged.
TEST(BenchmarkTest, ARefusedFileNameIsTheOnlyErrorOfItsRow) {
  BenchmarkFile file;
  const Document document = Document::parse(
      "schema = 1\n[[law]]\nlabel = \"a\"\nfile = 3\n[[reference]]\nfolder = \"r\"\n", "f.toml");
  try {
    read_document(document, file);
    FAIL();
  } catch (const Error& error) {
    EXPECT_EQ(dynamic_cast<const FileErrors*>(&error), nullptr);
    EXPECT_EQ(error.location().key, "law[0].file");
  }
}

}  // namespace
}  // namespace rebound

#include "comparisons/accuracy/tier_comparison/tier_record.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <memory>
#include <utility>

#include "comparisons/accuracy/numerical_error/reference_impact.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/io/toml/units.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/models/parallel/processor_time.hpp"
#include "lumped/integration/simulate.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

constexpr double least_share = 0x1p-40;

/// Scalars of a result by the keys that all results have.
template <class Result>
std::map<std::string, double> scalars_of(const Result& result) {
  const Json json = to_json(result);
  std::map<std::string, double> scalars;
  for (const std::string& key : compared_keys()) scalars[key] = json.at(key).template get<double>();
  return scalars;
}

/// Does what is asked; errors get their place in the file.
template <class Work>
auto located(const Document& document, const Work& work) {
  try {
    return work();
  } catch (const Error& error) {
    throw document.located(error);
  }
}

std::vector<double> speeds_of(const CompareCase& one, double of_file) {
  std::vector<double> speeds;
  for (const std::string& text : one.speeds)
    speeds.push_back(parse_quantity(text, dimension::speed));
  if (speeds.empty()) speeds.push_back(of_file);
  return speeds;
}

/// The FE tier, which counts the processor time of its impacts.
class TimedTier final : public FemTier {
 public:
  std::shared_ptr<const FemBody> prepare(const Mesh& mesh, double mass) const override {
    return std::make_shared<Body>(fem_tier().prepare(mesh, mass), seconds_);
  }
  CompressionResult compress(const CompressionProblem& problem, const Mesh& mesh,
                             const RunControl& control) const override {
    return fem_tier().compress(problem, mesh, control);
  }
  std::string versions() const override { return fem_tier().versions(); }
  double seconds() const { return *seconds_; }

 private:
  using Seconds = std::shared_ptr<std::atomic<double>>;

  struct Body final : FemBody {
    Body(std::shared_ptr<const FemBody> body, Seconds total)
        : timed(std::move(body)), seconds(std::move(total)) {}
    FemResult simulate(const FemProblem& problem, const RunControl& control) const override {
      const double start = thread_time();
      FemResult result = timed->simulate(problem, control);
      *seconds += thread_time() - start;
      return result;
    }
    std::shared_ptr<const FemBody> timed;
    Seconds seconds;
  };

  Seconds seconds_ = std::make_shared<std::atomic<double>>(0.0);
};

TierRecord lumped_record(const LumpedProblem& problem) {
  TierRecord record{.tier = "lumped",
                    .speed = problem.impact.speed,
                    .separation = name_of(problem.impact.separation),
                    .input_sha256 = sha256(write_toml(problem)),
                    .discretisation = {.scheme = "lumped"},
                    .scalars = {}};
  LumpedProblem tight = problem;
  constexpr double much_tighter = 1e-2, tightest = 1e-13;
  tight.controls.relative_tolerance =
      std::max(tightest, much_tighter * problem.controls.relative_tolerance);
  const auto at = scalars_of(simulate(problem)), tighter = scalars_of(simulate(tight)),
             other = scalars_of(simulate_fast(problem));
  for (const std::string& key : compared_keys()) {
    const double value = at.at(key);
    const double apart =
        std::max(std::abs(tighter.at(key) - value), std::abs(other.at(key) - value));
    const double bar = 2.0 * apart + least_share * std::abs(value);
    record.scalars[key] = {.value = value, .rounding = bar, .step = bar, .numerical = bar};
  }
  return record;
}

/// Scalars of the finest mesh of the reference family at speeds a hair above and below.
std::array<std::map<std::string, double>, 2> nudged(const FemTier& tier, const FemProblem& problem,
                                                    const Mesh& coarse, const RunControl& control) {
  const double radius = problem.sphere.radius();
  const Mesh fine = refined_mesh(refined_mesh(coarse, radius), radius);
  const auto body = tier.prepare(fine, problem.sphere.mass);
  std::array<std::map<std::string, double>, 2> scalars;
  in_parallel(scalars.size(), [&](std::size_t i) {
    FemProblem moved = problem;
    moved.impact.speed *= 1.0 + (i == 0 ? least_share : -least_share);
    scalars[i] = scalars_of(body->simulate(moved, RunControl{.interrupted = control.interrupted}));
  });
  return scalars;
}

TierRecord fem_record(const FemProblem& problem, const RunControl& control) {
  constexpr int family = 1 + 4 + 16;
  const Mesh coarse = mesh_for(problem, control, family);
  const TimedTier tier;
  const ReferenceImpact reference = run_reference(tier, problem, coarse, control);
  const auto beside = nudged(tier, problem, coarse, control);
  TierRecord record{.tier = "fem",
                    .speed = problem.impact.speed,
                    .separation = name_of(reference.result.scalars.separation),
                    .input_sha256 = sha256(write_toml(problem)),
                    .discretisation = {.scheme = name_of(problem.scheme),
                                       .cells = reference.result.cells,
                                       .vertices = reference.result.vertices,
                                       .smallest_step = reference.result.smallest_step},
                    .scalars = {},
                    .fem_seconds = tier.seconds()};
  const auto at = scalars_of(reference.result);
  for (const ScalarError& error : reference.errors) {
    const auto found = at.find(error.key);
    if (found == at.end()) continue;
    const double value = found->second;
    const double apart = std::max(std::abs(beside[0].at(error.key) - value),
                                  std::abs(beside[1].at(error.key) - value));
    const double rounding = 4.0 * apart + least_share * std::abs(value);
    record.scalars[error.key] = {.value = value,
                                 .rounding = rounding,
                                 .step = error.step + rounding,
                                 .numerical = error.uncertainty + rounding};
  }
  return record;
}

}  // namespace

std::vector<TierRecord> run_case(const CompareCase& one, const std::filesystem::path& folder,
                                 const RunControl& control) {
  std::vector<TierRecord> records;
  if (!one.lumped.empty()) {
    const Document document = Document::load(folder / one.lumped);
    LumpedProblem problem = read_lumped_problem(document);
    for (const double speed : speeds_of(one, problem.impact.speed)) {
      problem.impact.speed = speed;
      records.push_back(located(document, [&] { return lumped_record(problem); }));
    }
  }
  if (!one.fem.empty()) {
    const Document document = Document::load(folder / one.fem);
    FemProblem problem = read_fem_problem(document);
    problem.controls.field_frames = 0;
    for (const double speed : speeds_of(one, problem.impact.speed)) {
      problem.impact.speed = speed;
      records.push_back(located(document, [&] { return fem_record(problem, control); }));
    }
  }
  return records;
}

}  // namespace rebound

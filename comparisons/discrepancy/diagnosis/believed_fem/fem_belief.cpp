#include "comparisons/discrepancy/diagnosis/believed_fem/fem_belief.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <mutex>

#include "comparisons/discrepancy/diagnosis/believed_fem/contact_ripple.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/instrument/reported_deflection.hpp"
#include "comparisons/models/instrument/reported_force.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

constexpr std::size_t instants = 401;  // of a contact
constexpr std::size_t most_impacts = 10'000;

/// What instants are counted by: the time above 1 % of the peak force, and a tenth more. The last
/// node leaves when it likes, and a trace ends on a sample: by those the instants of a history
/// would jump by 0.4 % from one material to the next. A pull, which outlasts the push, and a plate
/// that rings on are followed to the end of the trace.
double span_of(const FemResult& result, const Plate& plate) {
  constexpr double beyond = 1.1, pulls = -1e-3;  // of the time, of the peak force
  const std::vector<double>& force = result.trace.force;
  const bool sticks =
      *std::min_element(force.begin(), force.end()) < pulls * result.scalars.peak_force;
  if (sticks || plate.moves()) return result.trace.time.back() - result.trace.time.front();
  return beyond * result.scalars.contact_time_1pct;
}

Trace at_equal_phases(const Trace& trace, double span) {
  Trace even;
  const double first = trace.time.front();
  for (std::size_t i = 0; i < instants; ++i)
    even.time.push_back(first + span * static_cast<double>(i) / (instants - 1));
  even.force = reported_force(trace, {}, even.time);
  even.deflection = reported_deflection(trace, {}, even.time);
  for (const TraceColumn& column : trace.further) {
    Trace alone{.time = trace.time, .force = {}, .deflection = column.values, .further = {}};
    alone.force = column.values;
    even.further.push_back({column.name, reported_deflection(alone, {}, even.time)});
  }
  return even;
}

double slowest_speed(const Observations& all, std::size_t ball) {
  double slowest = std::numeric_limits<double>::infinity();
  for (const MeasuredImpact& shot : all.shots)
    if (shot.ball == ball) slowest = std::min(slowest, shot.impact.speed);
  return slowest;
}

}  // namespace

/// Impacts by what they were run on.
class FemBelief::KeptImpacts {
 public:
  using Key = std::pair<std::vector<double>, std::vector<std::string>>;

  std::shared_ptr<const ModelledImpact> find(const Key& key) {
    const std::lock_guard lock(mutex_);
    const auto found = impacts_.find(key);
    return found == impacts_.end() ? nullptr : found->second;
  }
  void add(Key key, std::shared_ptr<const ModelledImpact> impact) {
    const std::lock_guard lock(mutex_);
    if (impacts_.size() >= most_impacts) impacts_.clear();
    impacts_.emplace(std::move(key), std::move(impact));
  }

 private:
  std::mutex mutex_;
  std::map<Key, std::shared_ptr<const ModelledImpact>> impacts_;
};

namespace {

auto key_of(std::size_t ball, const Impact& impact, const Material& material,
            const std::vector<EffectChoice>& effects) {
  std::vector<double> numbers{
      static_cast<double>(ball), impact.speed,           static_cast<double>(material.elastic),
      material.youngs_modulus,   material.poisson_ratio, material.second_share};
  std::vector<std::string> names;
  for (const StretchTerm& term : material.terms)
    numbers.insert(numbers.end(), {term.weight, term.exponent});
  for (const PronyBranch& branch : material.branches)
    numbers.insert(numbers.end(),
                   {branch.ratio, branch.relaxation_time, static_cast<double>(branch.relaxes),
                    branch.rate_exponent, branch.reference_strain});
  for (const EffectChoice& effect : effects) {
    names.push_back(effect.name);
    numbers.push_back(effect.size);
    for (const auto& [name, value] : effect.parameters) {
      names.push_back(name);
      numbers.push_back(value);
    }
  }
  return std::pair{std::move(numbers), std::move(names)};
}

}  // namespace

FemBelief::FemBelief(FemProblem problem, const Observations& all,
                     const std::vector<Material>& materials, int cells, const RunControl& control,
                     int halvings)
    : problem_(std::move(problem)), kept_(std::make_shared<KeptImpacts>()) {
  if (problem_.scheme != FemScheme::explicit_steps)
    throw Error(ExitCode::bad_input, "a diagnosis runs thousands of impacts",
                {.key = "model.scheme", .value = "implicit", .allowed = "explicit"});
  problem_.cells = cells;
  if (problem_.mesh_file.empty()) problem_.cells <<= 2 * halvings;
  for (std::size_t ball = 0; ball < all.balls.size(); ++ball) {
    spheres_.push_back(all.balls[ball].sphere);
    FemProblem slowest = problem_;
    slowest.sphere = spheres_.back();
    slowest.material = materials[ball];
    slowest.impact.speed = slowest_speed(all, ball);
    run_.emplace_back();
    if (slowest.impact.speed == std::numeric_limits<double>::infinity()) continue;  // never hit
    Mesh mesh = mesh_for(slowest, control);
    if (!problem_.mesh_file.empty())
      for (int k = 0; k < halvings; ++k) mesh = refined_mesh(mesh, slowest.sphere.radius());
    cells_ = std::max(cells_, static_cast<int>(mesh.cells.size()));
    run_.back() = fem_runner(mesh, slowest.sphere, control);
  }
}

FemBelief FemBelief::together(std::vector<std::shared_ptr<const FemBelief>> apart) {
  FemBelief all;
  all.problem_ = apart.at(0)->problem_;
  for (const auto& one : apart) all.cells_ = std::max(all.cells_, one->cells_);
  all.apart_ = std::move(apart);
  return all;
}

FemBelief FemBelief::with(const Material& material) const {
  FemBelief other = *this;
  other.problem_.material = material;
  for (auto& one : other.apart_) one = std::make_shared<const FemBelief>(one->with(material));
  return other;
}

FemBelief FemBelief::with(std::vector<KnownDifferences> known) const {
  FemBelief other = *this;
  for (std::size_t ball = 0; ball < apart_.size(); ++ball) {
    std::vector<KnownDifferences> own;
    for (const KnownDifferences& one : known)
      if (one.ball == ball) own.emplace_back(one).ball = 0;
    other.apart_[ball] = std::make_shared<const FemBelief>(apart_[ball]->with(std::move(own)));
  }
  other.known_ = std::move(known);
  return other;
}

const KnownDifferences* FemBelief::known_at(std::size_t ball, double speed) const {
  const KnownDifferences* nearest = nullptr;
  double least = std::numeric_limits<double>::infinity();
  for (const KnownDifferences& one : known_) {
    const double distance = std::abs(one.speed - speed) / one.speed;
    if (one.ball != ball || distance > one.reach || distance >= least) continue;
    least = distance;
    nearest = &one;
  }
  return nearest;
}

ModelledImpact FemBelief::run_anew(std::size_t ball, const FemProblem& problem) const {
  FemResult result;
  try {
    result = run_[ball](problem);
  } catch (const Error& error) {  // a search may try numbers that no file could hold
    if (error.code() != ExitCode::bad_input) throw;
    throw Error(ExitCode::solver_failed, error.what());
  }
  if (!result.incomplete_because.empty())
    throw Error(ExitCode::solver_failed, result.incomplete_because);
  ModelledImpact impact{.trace = at_equal_phases(result.trace, span_of(result, problem.plate)),
                        .scalars = result.scalars,
                        .plate = problem.plate};
  if (!problem.plate.moves())
    impact.trace.force = without_ripple(impact.trace.force, ripple_width(cells_));
  return impact;
}

ModelledImpact FemBelief::run(std::size_t ball, const Impact& impact, const Material& material,
                              const std::vector<EffectChoice>& effects) const {
  if (!apart_.empty()) return apart_[ball]->run(0, impact, material, effects);
  const KnownDifferences* known = known_at(ball, impact.speed);
  Impact at = impact;
  if (known) at.speed = known->speed;
  auto key = key_of(ball, at, material, effects);
  auto found = kept_->find(key);
  if (!found) {
    FemProblem problem = problem_;
    problem.sphere = spheres_[ball];
    problem.impact = at;
    problem.material = material;
    apply_effects(effects, problem);
    found = std::make_shared<const ModelledImpact>(run_anew(ball, problem));
    kept_->add(std::move(key), found);
  }
  ModelledImpact result = *found;
  if (!known) return result;
  known->finer.apply(result);
  known->carry_to(result, impact.speed);
  return result;
}

ModelledImpact times_as_heavy(ModelledImpact impact, double factor) {
  for (double& force : impact.trace.force) force *= factor;
  for (TraceColumn& column : impact.trace.further)
    if (column.name == contact_force_column)
      for (double& force : column.values) force *= factor;
  impact.scalars.peak_force *= factor;
  return impact;
}

}  // namespace rebound

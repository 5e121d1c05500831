#include "comparisons/accuracy/numerical_error/reference_impact.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <set>
#include <string_view>
#include <utility>

#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"
#include "meshes/refine/refined_mesh.hpp"

namespace rebound {
namespace {

void require_complete(const FemResult& result, const RunControl& control) {
  if (result.incomplete_because.empty()) return;
  const bool stopped = control.interrupted && control.interrupted();
  throw Error(stopped ? ExitCode::interrupted : ExitCode::solver_failed,
              "no error bar: the impact on " + std::to_string(result.cells) +
                  " cells did not complete: " + result.incomplete_because);
}

/// Largest |fine − medium| within `reach` samples of each; where the medium
/// trace has ended, its last value stands.
std::vector<double> band(const std::vector<double>& fine, const std::vector<double>& medium,
                         std::size_t reach) {
  std::vector<double> apart(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i)
    apart[i] = std::abs(fine[i] - medium[std::min(i, medium.size() - 1)]);
  std::vector<double> widest(fine.size());
  for (std::size_t i = 0; i < fine.size(); ++i) {
    const auto from = apart.begin() + static_cast<long>(i - std::min(i, reach));
    const auto to = apart.begin() + static_cast<long>(std::min(i + reach + 1, apart.size()));
    widest[i] = *std::max_element(from, to);
  }
  return widest;
}

void add_band(Trace& fine, const Trace& medium, double contact_time) {
  const double spacing = fine.time[1] - fine.time[0];
  const auto reach = static_cast<std::size_t>(std::ceil(contact_time / 50.0 / spacing));
  fine.further.push_back({"force_uncertainty_N", band(fine.force, medium.force, reach)});
  fine.further.push_back(
      {"deflection_uncertainty_m", band(fine.deflection, medium.deflection, reach)});
}

/// One impact of the family.
struct FamilyRun {
  std::shared_ptr<const FemBody> body;
  FemProblem problem;
};

/// The problem at another speed or step; pictures and fields belong to the result alone.
FemProblem varied(FemProblem problem, double speed_factor, double step_factor) {
  problem.controls.shape_frames = problem.controls.field_frames = 0;
  problem.impact.speed *= speed_factor;
  problem.controls.step_safety *= step_factor;
  return problem;
}

/// Root mean square of what the window means of two meshes differ by, within a twentieth of the
/// contact time of the peak: the front's ripple, which waves that cross the ball are no part of.
double ripple_at_peak(const FemResult& fine, const FemResult& medium) {
  const std::vector<double>&a = fine.window_force, &b = medium.window_force;
  const auto peak = static_cast<std::size_t>(std::max_element(a.begin(), a.end()) - a.begin());
  const double spacing = 0.25 * fine.force_averaging_window;
  const auto reach = static_cast<std::size_t>(0.05 * fine.scalars.contact_time / spacing) + 1;
  const std::size_t from = peak - std::min(peak, reach);
  const std::size_t to = std::min({a.size(), b.size(), peak + reach + 1});
  double square = 0.0;
  for (std::size_t i = from; i < to; ++i) square += (a[i] - b[i]) * (a[i] - b[i]);
  return from < to ? std::sqrt(square / static_cast<double>(to - from)) : 0.0;
}

bool has_two_forms(const FemProblem& problem) {
  const auto& branches = problem.material.branches;
  return problem.scheme == FemScheme::explicit_steps && !branches.empty() &&
         std::all_of(branches.begin(), branches.end(),
                     [](const PronyBranch& branch) { return branch.rate_exponent == 1.0; });
}

FemProblem in_other_form(FemProblem problem) {
  Relaxation& relaxation = problem.material.relaxation;
  relaxation =
      relaxation == Relaxation::convolution ? Relaxation::multiplicative : Relaxation::convolution;
  return varied(std::move(problem), 1.0, 1.0);
}

std::optional<ModelForm> model_form_of(const FemResult& other, const FemResult& middle,
                                       Relaxation relaxation) {
  if (!other.incomplete_because.empty()) return std::nullopt;
  ModelForm form{.other = relaxation, .difference = {}};
  for (const ScalarOfResult& scalar : scalars_with_error())
    form.difference.push_back(scalar.value(other) - scalar.value(middle));
  return form;
}

struct Members {
  FemResult small, halved;
  std::array<FemResult, 5> speeds;  ///< on the middle mesh; the third at the speed asked for
};

FamilyValues values_of(const ScalarOfResult& scalar, const Members& members,
                       const FemResult& fine) {
  std::array<double, 5> by_speed;
  std::transform(members.speeds.begin(), members.speeds.end(), by_speed.begin(), scalar.value);
  FamilyValues values{.coarse = scalar.value(members.small),
                      .middle = by_speed[2],
                      .fine = scalar.value(fine),
                      .halved = scalar.value(members.halved),
                      .scatter = scatter_about_parabola(by_speed)};
  if (std::string_view(scalar.key) == "peak_force_N")
    values.ripple = ripple_at_peak(fine, members.speeds[2]);
  return values;
}

/// Vertices of the plate's side of `mesh` within the contact radius.
int count_contact_nodes(const Mesh& mesh, double contact_radius) {
  std::set<int> inside;
  for (const auto& edge : mesh.contact_edges)
    for (const int vertex : edge)
      if (mesh.vertices[static_cast<std::size_t>(vertex)][0] <= contact_radius)
        inside.insert(vertex);
  return static_cast<int>(inside.size());
}

}  // namespace

const std::vector<ScalarOfResult>& scalars_with_error() {
  static const std::vector<ScalarOfResult> scalars = {
      {"restitution", [](const FemResult& r) { return r.scalars.restitution; }},
      {"contact_time_s", [](const FemResult& r) { return r.scalars.contact_time; }},
      {"contact_time_1pct_s", [](const FemResult& r) { return r.scalars.contact_time_1pct; }},
      {"contact_time_tail_s", [](const FemResult& r) { return r.contact_time_tail; }},
      {"peak_force_N", [](const FemResult& r) { return r.scalars.peak_force; }},
      {"peak_deflection_m", [](const FemResult& r) { return r.scalars.peak_deflection; }},
      {"mean_deflection_m", [](const FemResult& r) { return r.scalars.mean_deflection; }},
      {"rebound_speed_m_s", [](const FemResult& r) { return r.scalars.rebound_speed; }},
      {"kinetic_energy_loss_share",
       [](const FemResult& r) { return kinetic_energy_loss_share(r.scalars); }},
      {"restitution_momentum", [](const FemResult& r) { return r.restitution_momentum; }},
      {"contact_radius_peak_m", [](const FemResult& r) { return r.contact_radius_peak; }},
      {"vibrational_energy_share", [](const FemResult& r) { return r.vibrational_energy_share; }},
  };
  return scalars;
}

std::vector<std::string> beyond_reference_limit(const ReferenceImpact& reference) {
  std::vector<std::string> beyond;
  if (reference.contact_nodes < fewest_contact_nodes) beyond.emplace_back(contact_nodes_key);
  const auto& scalars = scalars_with_error();
  for (std::size_t i = 0; i < scalars.size(); ++i) {
    const std::string_view key = scalars[i].key;
    if (key != "peak_force_N" && key != "peak_deflection_m" && key != "contact_time_tail_s" &&
        key != "restitution")
      continue;
    const double value = std::abs(scalars[i].value(reference.result));
    if (!(reference.errors[i].uncertainty <= reference_limit * value)) beyond.emplace_back(key);
  }
  return beyond;
}

std::string words_of_reference(std::vector<std::string> beyond) {
  const std::string limit = fmt::format("known to {:g} %", 100.0 * reference_limit);
  if (std::erase(beyond, contact_nodes_key) != 0) {
    const std::string few =
        fmt::format("fewer than {} nodes in contact on the coarsest mesh", fewest_contact_nodes);
    return beyond.empty() ? few + "; more cells add some"
                          : few + ", and " + words_of_reference(beyond);
  }
  if (beyond.empty())
    return "peak force, peak deflection, contact time by its tail and restitution " + limit;
  return fmt::format("{} not {}; more cells narrow most bars", fmt::join(beyond, ", "), limit);
}

ReferenceImpact run_reference(const FemTier& tier, const FemProblem& problem, const Mesh& coarse,
                              const RunControl& control) {
  constexpr double nearby = 0.05;  // of the speed, from one to the next
  const double radius = problem.sphere.radius();
  const Mesh medium = refined_mesh(coarse, radius);
  const auto body = [&](const Mesh& mesh) { return tier.prepare(mesh, problem.sphere.mass); };
  const auto middle = body(medium);
  std::vector<FamilyRun> runs{{body(coarse), varied(problem, 1.0, 1.0)}};
  for (int i = 0; i < 5; ++i)
    runs.push_back({middle, varied(problem, 1.0 + nearby * (i - 2), 1.0)});
  runs.push_back({middle, varied(problem, 1.0, 0.5)});
  const bool two_forms = has_two_forms(problem);
  const std::size_t other_form = runs.size();
  if (two_forms) runs.push_back({middle, in_other_form(problem)});
  runs.push_back({body(refined_mesh(medium, radius)), problem});
  // The fine mesh takes about as long as all others together, so it begins first.
  std::vector<FemResult> results(runs.size());
  in_parallel(runs.size(), [&](std::size_t k) {
    const std::size_t i = runs.size() - 1 - k;
    const bool fine = k == 0;
    results[i] = runs[i].body->simulate(
        runs[i].problem, fine ? control : RunControl{.interrupted = control.interrupted});
    if (!(two_forms && i == other_form)) require_complete(results[i], control);
  });

  ReferenceImpact reference;
  for (std::size_t i = 0; i < runs.size(); ++i)
    reference.family.push_back({results[i].cells, runs[i].problem.impact.speed,
                                runs[i].problem.controls.step_safety, results[i].steps,
                                results[i].wall_seconds});
  reference.result = std::move(results.back());
  reference.contact_nodes = count_contact_nodes(coarse, reference.result.contact_radius_peak);
  Members members{.small = std::move(results[0]), .halved = std::move(results[6])};
  std::move(results.begin() + 1, results.begin() + 6, members.speeds.begin());
  if (two_forms)
    reference.model_form = model_form_of(results[other_form], members.speeds[2],
                                         runs[other_form].problem.material.relaxation);
  for (const ScalarOfResult& scalar : scalars_with_error()) {
    reference.values.push_back(values_of(scalar, members, reference.result));
    reference.errors.push_back(scalar_error(scalar.key, reference.values.back()));
  }
  add_band(reference.result.trace, members.speeds[2].trace, reference.result.scalars.contact_time);
  return reference;
}

}  // namespace rebound

#include "comparisons/studies/study/core_study.hpp"

#include <algorithm>
#include <mutex>

#include "comparisons/inference/calibration/platen_modulus.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/models/fem_access/fem_runner.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/studies/study/study_laws.hpp"
#include "lumped/problem/scalars.hpp"

namespace rebound {
namespace {

/// Share of a core's work done when each part ends; measured on one core.
constexpr double fit_share = 0.6;
constexpr double reference_share = 0.9;

void report_progress(const RunControl& control, double fraction) {
  if (control.progress) control.progress(fraction);
}

[[noreturn]] void refuse_data(const Dataset& data, const std::string& what) {
  throw Error(ExitCode::bad_input, "the study needs " + what, {.file = data.folder});
}

double platen_stiffness(const Dataset& data) {
  for (const auto& test : data.quasistatic)
    if (test.platens == 2 && test.stiffness.value) return *test.stiffness.value;
  refuse_data(data, "a [[quasistatic]] stiffness between two platens");
}

std::vector<MeasuredImpact> measured_impacts(const CoreStudy& core) {
  std::vector<MeasuredImpact> impacts;
  for (const auto& shot : core.data.shots) {
    if (!shot.restitution.value || !shot.restitution.uncertainty || !shot.contact_time.value ||
        !shot.contact_time.uncertainty)
      refuse_data(core.data,
                  "restitution and contact time, each with its uncertainty, of every shot");
    impacts.push_back(completed(core.data, shot));
    impacts.back().contact_threshold = core.contact_threshold;
    impacts.back().trace = {};  // the scalars are fitted
  }
  return impacts;
}

FemProblem start_problem(const StudyFem& fem, const CoreStudy& core) {
  FemProblem problem;
  problem.sphere = core.data.sphere;
  problem.material.elastic = fem.elastic;
  problem.material.youngs_modulus = core.long_term_modulus;
  problem.material.poisson_ratio = fem.poisson_ratio;
  problem.material.modulus = ModulusBasis::long_term;
  for (const auto& branch : fem.branches)
    problem.material.branches.push_back(
        {.ratio = branch.ratio, .relaxation_time = branch.relaxation_time});
  return problem;
}

std::vector<FreeMaterialNumber> free_numbers(const StudyFem& fem) {
  std::vector<FreeMaterialNumber> free;
  for (std::size_t i = 0; i < fem.branches.size(); ++i) {
    const auto& branch = fem.branches[i];
    // A decade and a half either way: beyond, a branch is either frozen or gone.
    constexpr double reach = 30.0;
    const auto add = [&](MaterialUnknown what, double start) {
      free.push_back({.what = what,
                      .branch = static_cast<int>(i),
                      .lowest = start / reach,
                      .highest = start * reach});
    };
    if (branch.fit_ratio) add(MaterialUnknown::branch_ratio, branch.ratio);
    if (branch.fit_time) add(MaterialUnknown::branch_time, branch.relaxation_time);
  }
  return free;
}

/// For the contact at the lowest speed of the core's shots.
FemRunner runner_on(FemProblem problem, const CoreStudy& core, int cells,
                    const RunControl& control) {
  problem.cells = cells;
  problem.impact.speed = core.data.shots.front().impact.speed;
  for (const auto& shot : core.data.shots)
    problem.impact.speed = std::min(problem.impact.speed, shot.impact.speed);
  return fem_runner(mesh_for(problem, control), core.data.sphere, control);
}

void fit_material(const StudyFem& fem, CoreStudy& core, const RunControl& control) {
  const FemRunner run = runner_on(start_problem(fem, core), core, fem.calibration_cells, control);
  // A typical fit: eight iterations, each the point and two differences per unknown.
  const double expected = 8.0 * (1.0 + 2.0 * static_cast<double>(free_numbers(fem).size())) *
                          static_cast<double>(core.data.shots.size());
  int done = 0;
  std::mutex one_at_a_time;  // impacts run two at once, and a progress line is one line
  const FemRunner counted = [&](const FemProblem& problem) {
    FemResult result = run(problem);
    const std::scoped_lock lock(one_at_a_time);
    const double share = std::min(0.95, static_cast<double>(++done) / expected);
    report_progress(control, fit_share * share);
    return result;
  };
  core.material =
      calibrate_material(start_problem(fem, core), measured_impacts(core), free_numbers(fem),
                         counted, {.interrupted = control.interrupted});
}

void run_references(const StudyFem& fem, CoreStudy& core, const RunControl& control) {
  FemProblem problem = start_problem(fem, core);
  problem.material = core.material.material;
  std::vector<Impact> impacts;
  for (const auto& shot : core.data.shots) impacts.push_back({.speed = shot.impact.speed});
  const auto run_on = [&](int cells, int shape_frames) {
    problem.cells = cells;
    problem.controls.shape_frames = shape_frames;
    auto results = run_impacts(problem, impacts, runner_on(problem, core, cells, control));
    for (const auto& result : results)
      if (!result.incomplete_because.empty())
        throw Error(ExitCode::solver_failed,
                    "FE reference of core " + core.label + ": " + result.incomplete_because);
    return results;
  };
  const auto coarse = run_on(fem.coarse_cells, 40);  // the shapes that the report animates
  const auto fine = run_on(fem.cells, 0);
  for (std::size_t i = 0; i < impacts.size(); ++i) {
    StudyShot shot{.measured = core.data.shots[i],
                   .problem = problem,
                   .fem = fine[i],
                   .fem_coarse = coarse[i],
                   .contact_time = time_above(fine[i].trace, core.contact_threshold)};
    shot.problem.impact = impacts[i];
    core.shots.push_back(std::move(shot));
  }
}

/// The paper's model as the paper used it: one stiffness, damping by Eq. (8)
/// from each measured restitution.
Diagnosis diagnose_paper_model(const CoreStudy& core, const RunControl& control) {
  DiagnosisRequest request;
  request.datasets = {core.data};
  request.believed.law = "hunt-crossley";
  request.believed.parameters["stiffness"] = core.published.hunt_crossley_stiffness.value;
  request.believed.damping_formula = "hunt-crossley";
  request.believed.restitution = core.data.shots.front().restitution.value;
  return diagnose(request, control);
}

}  // namespace

CoreStudy study_core(const StudyFile& study, const StudyCore& which, const RunControl& control) {
  CoreStudy core;
  core.label = which.label;
  core.data = read_dataset(which.data);
  core.published = read_published_values(which.data);
  core.contact_threshold =
      core.data.instrument.contact_threshold.value_or(study.fem.contact_threshold);
  const PlatenTest platens{.stiffness = platen_stiffness(core.data),
                           .diameter = core.data.sphere.diameter,
                           .poisson_ratio = study.fem.poisson_ratio,
                           .shortest_travel = study.fem.shortest_travel,
                           .longest_travel = study.fem.longest_travel};
  core.long_term_modulus = modulus_from_platens(platens);
  core.long_term_modulus_hertz = modulus_from_platens_hertz(platens);

  fit_material(study.fem, core, control);
  report_progress(control, fit_share);
  run_references(study.fem, core, control);
  report_progress(control, reference_share);
  calibrate_laws(core);
  core.benchmark = score_laws(core, {.interrupted = control.interrupted});
  core.diagnosis = diagnose_paper_model(core, {.interrupted = control.interrupted});
  report_progress(control, 1.0);
  return core;
}

}  // namespace rebound

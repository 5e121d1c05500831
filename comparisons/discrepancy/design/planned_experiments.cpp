#include "comparisons/discrepancy/design/planned_experiments.hpp"

#include <algorithm>
#include <atomic>

#include "comparisons/discrepancy/diagnosis/diagnosis.hpp"
#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/discrepancy/trials/trial_answer.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// The rows of the table, nothing hidden first.
std::vector<CountedChance> rows_of(const TestDesign& design, const PlannedExperiments& wanted) {
  std::vector<CountedChance> rows{{.effect = {}, .predicted = design.nothing_hidden}};
  for (const FindableEffect& one : design.effects)
    if (!wanted.effect || *wanted.effect == one.name)
      for (const SizeOfChance& size : one.sizes) rows.push_back({one.name, size});
  if (wanted.effect && rows.size() == 1)
    throw Error(ExitCode::bad_input, "this plan finds no such effect wherever its numbers lie",
                {.key = "--effect",
                 .value = *wanted.effect,
                 .allowed = "an effect with a size in the table of the plan"});
  return rows;
}

/// What a diagnosis said of one experiment.
struct Said {
  bool failed = false, gap = false, named = false, family = false;
};

DiagnosisRequest request_for(const SynthesisFile& plan, Dataset data, std::uint64_t seed) {
  DiagnosisRequest request;
  request.datasets = {std::move(data)};
  if (plan.tier == Tier::fem)
    request.believed_fem = plan.fem;
  else
    request.believed = plan.lumped;
  request.ask_fem = false;
  request.rules.bootstrap_draws = 0;
  request.seed = seed;
  return request;
}

Said said_of(const SynthesisFile& plan, const CountedChance& row, std::int64_t place,
             std::uint64_t seed, const RunControl& control) {
  SynthesisFile file = plan;
  file.seed += 1 + place;
  if (!row.effect.empty()) file.effects = {row.predicted.hidden};
  try {
    const Dataset data = synthesize(file, simulator_of(file, control), control).dataset;
    const Diagnosis d = diagnose(request_for(plan, data, seed), control);
    TrialAnswer answer{
        .verdict = name_of(d.verdict), .family = {}, .candidates = d.candidates, .named = {}};
    if (d.family != EffectFamily::none) answer.family = name_of(d.family);
    Said said{.gap = says_gap(answer)};
    if (!said.gap || row.effect.empty()) return said;
    const std::string family = name_of(find_effect(row.effect).card.family);
    said.named = d.verdict != DiagnosisVerdict::unexplained && name_is_said(answer, row.effect);
    said.family = family_said(answer) == family || family_in_a_candidate(answer, family);
    return said;
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    return {.failed = true};
  }
}

}  // namespace

std::vector<CountedChance> count_chances(const SynthesisFile& plan, const TestDesign& design,
                                         const PlannedExperiments& wanted,
                                         const RunControl& control) {
  std::vector<CountedChance> rows = rows_of(design, wanted);
  const auto each = static_cast<std::size_t>(wanted.experiments);
  std::vector<Said> all(rows.size() * each);
  std::atomic<std::size_t> done = 0;
  const RunControl parts{.interrupted = control.interrupted, .progress = {}};
  in_parallel(all.size(), [&](std::size_t i) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted, "interrupted: not all experiments were counted");
    all[i] = said_of(plan, rows[i / each], static_cast<std::int64_t>(i), wanted.seed, parts);
    const std::size_t so_far = ++done;
    if (control.progress)
      control.progress(static_cast<double>(so_far) / static_cast<double>(all.size()));
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    CountedChance& row = rows[i / each];
    if (all[i].failed) {
      ++row.failed;
      continue;
    }
    row.gap.add(all[i].gap);
    row.named.add(all[i].named);
    row.family.add(all[i].family);
  }
  return rows;
}

}  // namespace rebound

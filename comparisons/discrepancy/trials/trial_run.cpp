#include "comparisons/discrepancy/trials/trial_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <memory>
#include <set>
#include <tuple>

#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/discrepancy/diagnosis/verdict/verdict.hpp"
#include "comparisons/discrepancy/trials/trial_controls.hpp"
#include "comparisons/discrepancy/trials/trial_store.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// One trial of a run.
struct TrialPlace {
  const TrialFolder* folder;
  TrialStore* store;
  std::filesystem::path data;
  int number;
  std::string digest;
};

std::vector<TrialPlace> places_of(const TrialFolder& folder, TrialStore& store) {
  std::vector<TrialPlace> places;
  if (std::filesystem::is_directory(folder.data / "trials"))
    for (const auto& entry : std::filesystem::directory_iterator(folder.data / "trials"))
      if (entry.is_directory())
        places.push_back({&folder, &store, entry.path(), std::atoi(entry.path().filename().c_str()),
                          digest_of_folder(entry.path())});
  if (places.empty())
    throw Error(ExitCode::bad_input, "holds no trials",
                {.file = folder.data.string(), .allowed = "a folder that trial_generator wrote"});
  std::sort(places.begin(), places.end(),
            [](const TrialPlace& a, const TrialPlace& b) { return a.number < b.number; });
  return places;
}

DiagnosisRequest request_of(const std::filesystem::path& trial, const TrialProtocol& protocol) {
  DiagnosisRequest request =
      request_for(Document::load((trial / "model.toml").string()), {read_dataset(trial.string())});
  request.ask_fem = protocol.ask_fem;
  request.rules = protocol.rules;
  request.seed = protocol.seed;
  return request;
}

void describe_data(const Dataset& data, TrialOutcome& outcome) {
  std::set<double> speeds;
  for (const MeasuredImpact& shot : data.shots) speeds.insert(shot.impact.speed);
  outcome.speeds = static_cast<int>(speeds.size());
  outcome.shots = static_cast<int>(data.shots.size());
}

void describe_verdict(const Diagnosis& d, TrialOutcome& outcome) {
  outcome.said.verdict = name_of(d.verdict);
  if (d.family != EffectFamily::none) outcome.said.family = name_of(d.family);
  outcome.said.candidates = d.candidates;
  for (const FamilySet& families : families_of_candidates(d)) {
    auto& names = outcome.said.candidate_families.emplace_back();
    for (const EffectFamily family : families) names.emplace_back(name_of(family));
  }
  for (const ExplainedShare& one : d.nearest) outcome.said.nearest.push_back(one.effects.front());
  outcome.held_out_before = d.gap.held_out_before;
  outcome.held_out_after = d.gap.held_out_after;
  outcome.held_out_noise = d.gap.held_out_noise;
  outcome.warnings = d.warnings;
  if (d.effects.size() != 1 || d.candidates.size() != 1) return;
  const NamedEffect& effect = d.effects.front();
  outcome.said.named = effect.effect.name;
  outcome.size = effect.size.value;
  outcome.size_low = effect.size.low;
  outcome.size_high = effect.size.high;
}

Error interruption() {
  return {ExitCode::interrupted,
          "interrupted; outcomes so far are kept, the same command goes on with the rest"};
}

TrialOutcome diagnose_trial(const TrialPlace& place, const TrialProtocol& protocol,
                            const RunControl& control) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  TrialOutcome outcome{
      .trial = place.number, .said = {}, .failure = {}, .warnings = {}, .controls = {}};
  outcome.protocol = protocol_digest(to_json(protocol));
  const auto seconds = [&] { return std::chrono::duration<double>(Clock::now() - start).count(); };
  try {
    const DiagnosisRequest request = request_of(place.data, protocol);
    describe_data(request.datasets.front(), outcome);
    const Diagnosis diagnosis = diagnose(request, {.interrupted = control.interrupted});
    outcome.seconds = seconds();
    describe_verdict(diagnosis, outcome);
    outcome.controls =
        answers_of_controls(diagnosis, protocol.seed, bytes_of(place.data / "dataset.toml"));
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw interruption();
    outcome.failure = error.what();
    const TrialAnswer failed{.verdict = "failed", .family = {}, .candidates = {}, .named = {}};
    if (outcome.said.verdict.empty()) {  // else it was a control that failed
      outcome.said = failed;
      outcome.seconds = seconds();
    }
    for (const ControlName& name : control_names) outcome.controls[name.key] = failed;
  }
  return outcome;
}

void refuse_mixed(const TrialProtocols& protocols, const TrialRun& run) {
  if (!run.mixed) refuse_several(protocols, run.folders.front().outcomes.string());
}

/// A trial that has its outcome.
struct DoneTrial {
  TrialPlace place;
  TrialOutcome outcome;
};

/// Trials of all folders with the outcomes that stand.
class TrialPlaces {
 public:
  explicit TrialPlaces(const TrialRun& run) {
    for (const TrialFolder& folder : run.folders) {
      TrialStore& store =
          *stores_.emplace_back(std::make_unique<TrialStore>(folder.outcomes)).get();
      for (TrialPlace& place : places_of(folder, store)) add(std::move(place));
    }
  }

  std::vector<DoneTrial> done;
  std::vector<TrialPlace> pending;
  TrialProtocols protocols;  ///< of what is done

 private:
  void add(TrialPlace place) {
    std::optional<TrialOutcome> outcome = place.store->find(place.digest);
    if (!outcome) {
      pending.push_back(std::move(place));
      return;
    }
    outcome->trial = place.number;
    protocols[outcome->protocol] = place.store->protocols().at(outcome->protocol);
    done.push_back({std::move(place), std::move(*outcome)});
  }

  std::vector<std::unique_ptr<TrialStore>> stores_;
};

}  // namespace

TrialProgress run_trials(const TrialRun& run, const RunControl& control) {
  TrialPlaces places(run);
  std::vector<TrialPlace>& pending = places.pending;
  const std::size_t trials = places.done.size() + pending.size();
  if (run.most && *run.most < pending.size())
    pending.erase(pending.begin() + static_cast<std::ptrdiff_t>(*run.most), pending.end());
  const TrialProtocol protocol = protocol_of_this_program(run.seed, run.ask_fem);
  if (!pending.empty()) places.protocols[protocol_digest(to_json(protocol))] = to_json(protocol);
  refuse_mixed(places.protocols, run);
  std::set<TrialStore*> written;
  for (const TrialPlace& place : pending) written.insert(place.store);
  for (const TrialFolder& folder : run.folders) make_writable_folder(folder.outcomes);
  for (TrialStore* store : written) store->write(to_json(protocol));
  std::atomic<std::size_t> diagnosed = 0;
  in_parallel(pending.size(), [&](std::size_t i) {
    if (control.interrupted && control.interrupted()) throw interruption();
    pending[i].store->keep(pending[i].digest, diagnose_trial(pending[i], protocol, control));
    ++diagnosed;
    if (control.progress)
      control.progress(static_cast<double>(diagnosed) / static_cast<double>(pending.size()));
  });
  return {.with_outcome = places.done.size() + diagnosed, .trials = trials};
}

TrialCollection open_trials(const TrialRun& run) {
  TrialPlaces places(run);
  if (!places.pending.empty())
    throw Error(ExitCode::bad_input, "a trial has no outcome yet; no truth is opened",
                {.file = places.pending.front().data.string()});
  refuse_mixed(places.protocols, run);
  TrialCollection all{.records = {}, .protocols = std::move(places.protocols)};
  std::set<std::tuple<std::string, std::uint64_t, int>> known;
  auto next = places.done.begin();
  for (const TrialFolder& folder : run.folders) {
    std::vector<TrialOutcome> outcomes;
    for (; next != places.done.end() && next->place.folder == &folder; ++next)
      outcomes.push_back(std::move(next->outcome));
    for (TrialRecord& record : records_of(outcomes, read_truths(folder.data))) {
      const TrialTruth& truth = record.truth;
      if (!known.emplace(truth.set, truth.seed, truth.trial).second)
        throw Error(ExitCode::bad_input,
                    fmt::format("trial {} of set \"{}\", seed {}, stands in two folders",
                                truth.trial, truth.set, truth.seed),
                    {.file = folder.data.string(), .allowed = "every trial once"});
      all.records.push_back(std::move(record));
    }
  }
  return all;
}

std::vector<TrialRecord> records_of(const std::vector<TrialOutcome>& outcomes,
                                    const std::vector<TrialTruth>& truths) {
  if (outcomes.size() != truths.size())
    throw Error(ExitCode::corrupt_store, "trials and truths are not as many");
  std::vector<TrialRecord> records;
  for (std::size_t i = 0; i < truths.size(); ++i) {
    if (truths[i].trial != outcomes[i].trial)
      throw Error(ExitCode::corrupt_store, "trials and truths are not the same");
    records.push_back({truths[i], outcomes[i]});
  }
  return records;
}

}  // namespace rebound

#include "comparisons/discrepancy/trials/trial_run.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <fstream>
#include <sstream>

#include "comparisons/discrepancy/diagnosis/believed_model.hpp"
#include "comparisons/io/dataset/read_dataset.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::string text_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream text;
  text << in.rdbuf();
  return text.str();
}

std::vector<int> trials_of(const std::filesystem::path& folder) {
  std::vector<int> numbers;
  if (std::filesystem::is_directory(folder / "trials"))
    for (const auto& entry : std::filesystem::directory_iterator(folder / "trials"))
      if (entry.is_directory()) numbers.push_back(std::atoi(entry.path().filename().c_str()));
  if (numbers.empty())
    throw Error(ExitCode::bad_input, "holds no trials",
                {.file = folder.string(), .allowed = "a folder that trial_generator wrote"});
  std::sort(numbers.begin(), numbers.end());
  return numbers;
}

DiagnosisRequest request_of(const std::filesystem::path& trial, std::uint64_t seed) {
  DiagnosisRequest request;
  request.datasets = {read_dataset(trial.string())};
  const BelievedModel believed =
      read_believed_model(Document::load((trial / "model.toml").string()), request.datasets);
  request.believed = believed.model;
  request.believed_effects = believed.effects;
  request.ask_fem = false;  // nothing of these trials comes from a body of finite size
  request.seed = seed;
  return request;
}

void describe_verdict(const Diagnosis& d, TrialOutcome& outcome) {
  outcome.verdict = name_of(d.verdict);
  if (d.family != EffectFamily::none) outcome.family = name_of(d.family);
  outcome.candidates = d.candidates;
  outcome.held_out_before = d.gap.held_out_before;
  outcome.held_out_after = d.gap.held_out_after;
  outcome.held_out_noise = d.gap.held_out_noise;
  outcome.warnings = d.warnings;
  if (d.effects.size() != 1 || d.candidates.size() != 1) return;
  const NamedEffect& effect = d.effects.front();
  outcome.named = effect.effect.name;
  outcome.size = effect.size.value;
  outcome.size_low = effect.size.low;
  outcome.size_high = effect.size.high;
}

TrialOutcome diagnose_trial(int number, const TrialRun& run, const RunControl& control) {
  using Clock = std::chrono::steady_clock;
  const auto start = Clock::now();
  TrialOutcome outcome{.trial = number};
  try {
    const auto trial = run.folder / "trials" / fmt::format("{:04}", number);
    describe_verdict(diagnose(request_of(trial, run.seed), {.interrupted = control.interrupted}),
                     outcome);
  } catch (const Error& error) {
    if (error.code() == ExitCode::interrupted) throw;
    outcome.verdict = "failed";
    outcome.failure = error.what();
  }
  outcome.seconds = std::chrono::duration<double>(Clock::now() - start).count();
  return outcome;
}

Json value_or_null(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

std::optional<double> optional_number(const Json& json) {
  return json.is_null() ? std::nullopt : std::optional(json.get<double>());
}

}  // namespace

Json to_json(const TrialOutcome& outcome) {
  return {
      {"schema", 1},
      {"trial", outcome.trial},
      {"verdict", outcome.verdict},
      {"failure", outcome.failure},
      {"family", outcome.family},
      {"candidates", outcome.candidates},
      {"named", outcome.named},
      {"size", {outcome.size, outcome.size_low, outcome.size_high}},
      {"held_out", {value_or_null(outcome.held_out_before), value_or_null(outcome.held_out_after)}},
      {"held_out_noise", outcome.held_out_noise},
      {"warnings", outcome.warnings},
      {"seconds", outcome.seconds}};
}

TrialOutcome trial_outcome_from(const std::string& text, const std::string& file) {
  try {
    const Json json = Json::parse(text);
    TrialOutcome outcome{.trial = json.at("trial"),
                         .verdict = json.at("verdict"),
                         .failure = json.at("failure"),
                         .family = json.at("family"),
                         .candidates = json.at("candidates"),
                         .named = json.at("named")};
    outcome.size = json.at("size").at(0);
    outcome.size_low = json.at("size").at(1);
    outcome.size_high = json.at("size").at(2);
    outcome.held_out_before = optional_number(json.at("held_out").at(0));
    outcome.held_out_after = optional_number(json.at("held_out").at(1));
    outcome.held_out_noise = json.at("held_out_noise");
    outcome.warnings = json.at("warnings").get<std::vector<std::string>>();
    outcome.seconds = json.at("seconds");
    return outcome;
  } catch (const Json::exception& error) {
    throw Error(ExitCode::corrupt_store,
                std::string("is not the outcome of a trial: ") + error.what(), {.file = file});
  }
}

std::vector<TrialOutcome> run_trials(const TrialRun& run, const RunControl& control) {
  const std::vector<int> numbers = trials_of(run.folder);
  make_writable_folder(run.outcomes);
  std::vector<TrialOutcome> outcomes(numbers.size());
  std::atomic<std::size_t> done = 0;
  in_parallel(numbers.size(), [&](std::size_t i) {
    if (control.interrupted && control.interrupted())
      throw Error(ExitCode::interrupted,
                  "interrupted; outcomes so far are kept, the same command goes on with the rest");
    const auto file = run.outcomes / fmt::format("{:04}.json", numbers[i]);
    if (std::filesystem::exists(file)) {
      outcomes[i] = trial_outcome_from(text_of(file), file.string());
    } else {
      outcomes[i] = diagnose_trial(numbers[i], run, control);
      write_file_atomically(file, dump(to_json(outcomes[i])));
    }
    ++done;
    if (control.progress)
      control.progress(static_cast<double>(done) / static_cast<double>(numbers.size()));
  });
  return outcomes;
}

}  // namespace rebound

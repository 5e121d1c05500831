#include "comparisons/inference/calibration/evaluation_cache.hpp"

#include <algorithm>
#include <cmath>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/document.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {

namespace {

constexpr std::size_t largest_file = std::size_t{1} << 30;

std::string digest_of(const CalibrationProblem& problem) {
  Json json = Json::array();
  for (const auto& p : problem.parameters)
    json.push_back({p.name, p.unit, p.start, p.lowest, p.highest, p.scale});
  const auto& c = problem.controls;
  json.push_back({c.relative_step, c.cost_tolerance, c.iterations, c.starts, c.seed,
                  static_cast<int>(c.loss), c.loss_scale});
  return sha256(json.dump());
}

}  // namespace

EvaluationCache::EvaluationCache(const CalibrationProblem& problem,
                                 const std::vector<double>& first,
                                 std::chrono::milliseconds interval)
    : residuals_(problem.residuals),
      file_(problem.controls.checkpoint),
      digest_(digest_of(problem)),
      interval_(interval),
      saved_(std::chrono::steady_clock::now()) {
  std::vector<double> start;
  for (const auto& p : problem.parameters) start.push_back(p.start);
  if (std::filesystem::exists(file_)) {
    load();
    // Other data give other residuals at the start.
    const auto found = answers_.find(start);
    if (found == answers_.end() || !found->second || first != *found->second)
      throw Error(ExitCode::bad_input,
                  "this checkpoint belongs to other data or another model: remove it to begin anew",
                  {.file = file_.string()});
  }
  answers_[start] = first;
}

void EvaluationCache::load() {
  const auto corrupt = [&](const std::string& why) {
    return Error(ExitCode::corrupt_store,
                 "this calibration checkpoint is damaged (" + why + "): remove it to begin anew",
                 {.file = file_.string()});
  };
  const std::string text = read_text_file(file_, largest_file);
  try {
    const Json json = Json::parse(text);
    const Json& body = json.at("body");
    if (json.at("sha256") != sha256(body.dump())) throw corrupt("its digest does not agree");
    if (body.at("calibration") != digest_)
      throw Error(ExitCode::bad_input,
                  "this checkpoint belongs to another calibration: remove it to begin anew",
                  {.file = file_.string()});
    for (const auto& entry : body.at("evaluations")) {
      Answer answer;
      if (!entry.at("residuals").is_null())
        answer = entry.at("residuals").get<std::vector<double>>();
      answers_[entry.at("at").get<std::vector<double>>()] = std::move(answer);
    }
  } catch (const Json::exception& error) {
    throw corrupt(error.what());
  }
}

std::vector<double> EvaluationCache::operator()(const std::vector<double>& x) {
  const auto no_answer = [] {
    return Error(ExitCode::solver_failed, "the model has no answer here");
  };
  if (const auto found = answers_.find(x); found != answers_.end()) {
    ++from_file_;
    if (!found->second) throw no_answer();
    return *found->second;
  }
  Answer answer;
  try {
    answer = residuals_(x);
  } catch (const Error& error) {
    if (error.code() != ExitCode::solver_failed) {
      save();
      throw;
    }
  }
  // A number that is none cannot be stored, and means the same.
  if (answer &&
      !std::all_of(answer->begin(), answer->end(), [](double r) { return std::isfinite(r); }))
    answer.reset();
  answers_[x] = answer;
  unsaved_ = true;
  if (std::chrono::steady_clock::now() - saved_ >= interval_) save();
  if (!answer) throw no_answer();
  return *answer;
}

void EvaluationCache::save() {
  if (!unsaved_) return;
  Json evaluations = Json::array();
  for (const auto& [at, answer] : answers_)
    evaluations.push_back({{"at", at}, {"residuals", answer ? Json(*answer) : Json(nullptr)}});
  const Json body = {{"calibration", digest_}, {"evaluations", std::move(evaluations)}};
  write_file_atomically(
      file_, Json{{"schema", 1}, {"sha256", sha256(body.dump())}, {"body", body}}.dump());
  unsaved_ = false;
  saved_ = std::chrono::steady_clock::now();
}

}  // namespace rebound

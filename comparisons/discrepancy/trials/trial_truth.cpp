#include "comparisons/discrepancy/trials/trial_truth.hpp"

#include <algorithm>
#include <fstream>
#include <map>
#include <sstream>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/json.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Digest by file name, from lines "DIGEST  FILE".
std::map<std::string, std::string> seals_of(const std::filesystem::path& folder) {
  std::ifstream in(folder / "sealed.txt");
  std::map<std::string, std::string> seals;
  for (std::string digest, file; in >> digest >> file;)
    seals[std::filesystem::path(file).filename()] = digest;
  return seals;
}

TrialEffect effect_of(const Json& json) {
  TrialEffect effect{.family = json.at("family"),
                     .form = json.at("name"),
                     .registry_name = json.at("registry_name").is_string()
                                          ? json.at("registry_name").get<std::string>()
                                          : std::string(),
                     .in_registry = json.at("in_registry")};
  if (json.contains("registry_size")) effect.registry_size = json.at("registry_size");
  return effect;
}

/// Truths of nulls, and those that were written before, say nothing of rivals.
std::optional<double> cosine_of(const Json& json, const char* key) {
  if (!json.contains(key) || json.at(key).at("form") == "") return std::nullopt;
  return json.at(key).at("cosine").get<double>();
}

TrialTruth truth_of(const Json& json) {
  TrialTruth truth{.set = json.at("set"),
                   .seed = json.at("seed"),
                   .trial = json.at("trial"),
                   .effects = {},
                   .visible_chi_square = json.at("visible_chi_square"),
                   .nearest_family = cosine_of(json, "nearest_of_other_family"),
                   .nearest_name = cosine_of(json, "nearest_of_other_name"),
                   .noise_colour = json.at("noise").at("colour"),
                   .noise_stated = json.at("noise").at("stated"),
                   .ball = json.contains("ball") ? json.at("ball").at("material") : Json(""),
                   .believed = json.value("believed", "lumped"),
                   .noise_share = json.at("noise").at("share_of_smallest_baseline_peak")};
  for (const Json& effect : json.at("effects")) truth.effects.push_back(effect_of(effect));
  return truth;
}

}  // namespace

std::vector<TrialTruth> read_truths(const std::filesystem::path& folder) {
  const auto seals = seals_of(folder);
  std::vector<TrialTruth> truths;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "truth")) {
    std::ifstream in(entry.path(), std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    const auto seal = seals.find(entry.path().filename());
    if (seal == seals.end() || seal->second != sha256(text.str()))
      throw Error(ExitCode::corrupt_store, "is not the truth that was sealed",
                  {.file = entry.path().string(),
                   .allowed = "the bytes whose digest stands in sealed.txt"});
    try {
      truths.push_back(truth_of(Json::parse(text.str())));
    } catch (const Json::exception& error) {
      throw Error(ExitCode::corrupt_store, error.what(), {.file = entry.path().string()});
    }
  }
  std::sort(truths.begin(), truths.end(),
            [](const TrialTruth& a, const TrialTruth& b) { return a.trial < b.trial; });
  return truths;
}

}  // namespace rebound

#include "comparisons/evaluation/atlas/impact_store.hpp"

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/json.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "lumped/problem/atomic_file.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

Json body_of(const AtlasImpact& impact) {
  const auto& s = impact.shot.scalars;
  return {{"failure", impact.failure},
          {"restitution", s.restitution},
          {"contact_time", s.contact_time},
          {"contact_time_1pct", s.contact_time_1pct},
          {"peak_force", s.peak_force},
          {"peak_deflection", s.peak_deflection},
          {"mean_deflection", s.mean_deflection},
          {"rebound_speed", s.rebound_speed},
          {"time", impact.shot.trace.time},
          {"force", impact.shot.trace.force},
          {"deflection", impact.shot.trace.deflection}};
}

AtlasImpact impact_of(const Json& body, const FemProblem& problem) {
  AtlasImpact impact;
  impact.failure = body.at("failure").get<std::string>();
  impact.shot.sphere = problem.sphere;
  impact.shot.impact = problem.impact;
  auto& s = impact.shot.scalars;
  const std::pair<const char*, double*> scalars[] = {{"restitution", &s.restitution},
                                                     {"contact_time", &s.contact_time},
                                                     {"contact_time_1pct", &s.contact_time_1pct},
                                                     {"peak_force", &s.peak_force},
                                                     {"peak_deflection", &s.peak_deflection},
                                                     {"mean_deflection", &s.mean_deflection},
                                                     {"rebound_speed", &s.rebound_speed}};
  for (const auto& [key, value] : scalars) *value = body.at(key).get<double>();
  s.separation = problem.impact.separation;
  impact.shot.trace.time = body.at("time").get<std::vector<double>>();
  impact.shot.trace.force = body.at("force").get<std::vector<double>>();
  impact.shot.trace.deflection = body.at("deflection").get<std::vector<double>>();
  return impact;
}

}  // namespace

std::filesystem::path ImpactStore::file_of(const FemProblem& problem) const {
  return folder_ / (sha256(write_toml(problem)).substr(0, 24) + ".json");
}

std::optional<AtlasImpact> ImpactStore::find(const FemProblem& problem) const {
  const auto file = file_of(problem);
  if (!std::filesystem::exists(file)) return std::nullopt;
  const auto corrupt = [&](const std::string& why) {
    return Error(ExitCode::corrupt_store,
                 "a stored impact of the atlas is damaged (" + why + "): remove it to run it again",
                 {.file = file.string()});
  };
  try {
    const Json json = Json::parse(read_text_file(file));
    if (json.at("sha256") != sha256(json.at("body").dump()))
      throw corrupt("its digest does not agree");
    return impact_of(json.at("body"), problem);
  } catch (const Json::exception& error) {
    throw corrupt(error.what());
  }
}

void ImpactStore::keep(const FemProblem& problem, const AtlasImpact& impact) const {
  const Json body = body_of(impact);
  write_file_atomically(
      file_of(problem),
      Json{{"schema", 1}, {"sha256", sha256(body.dump())}, {"body", body}}.dump());
}

}  // namespace rebound

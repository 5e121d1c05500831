#include "comparisons/evaluation/atlas/impact_store.hpp"

#include <limits>

#include "comparisons/io/result_store/running_program.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/document.hpp"
#include "comparisons/io/toml/toml_writer.hpp"

namespace rebound {
namespace {

constexpr double none = std::numeric_limits<double>::quiet_NaN();

MemberResult member_of(const AtlasImpact& impact) {
  const ImpactScalars& s = impact.shot.scalars;
  const Trace& trace = impact.shot.trace;
  return {
      .scalars = {s.restitution, s.contact_time, s.contact_time_1pct, s.peak_force,
                  s.peak_deflection, s.mean_deflection, s.rebound_speed, none, none, none},
      .failure = impact.failure,
      .trace = {
          {"time_s", trace.time}, {"force_N", trace.force}, {"deflection_m", trace.deflection}}};
}

AtlasImpact impact_of(MemberResult member, const FemProblem& problem) {
  AtlasImpact impact{.failure = std::move(member.failure), .shot = {}};
  impact.shot.sphere = problem.sphere;
  impact.shot.impact = problem.impact;
  ImpactScalars& s = impact.shot.scalars;
  double* const places[] = {&s.restitution,  &s.contact_time,    &s.contact_time_1pct,
                            &s.peak_force,   &s.peak_deflection, &s.mean_deflection,
                            &s.rebound_speed};
  for (std::size_t i = 0; i < std::size(places); ++i) *places[i] = member.scalars[i];
  s.separation = problem.impact.separation;
  Trace& trace = impact.shot.trace;
  for (TraceColumn& column : member.trace) {
    if (column.name == "time_s") trace.time = std::move(column.values);
    if (column.name == "force_N") trace.force = std::move(column.values);
    if (column.name == "deflection_m") trace.deflection = std::move(column.values);
  }
  return impact;
}

}  // namespace

ImpactStore::ImpactStore(const std::filesystem::path& file, std::string mesh)
    : program_(running_program()),
      mesh_(std::move(mesh)),
      store_(file, ResultStore::Access::write, program_) {}

std::string ImpactStore::key_of(const FemProblem& problem) const {
  return member_key(program_ + "\natlas\n" + mesh_ + "\n" + write_toml(problem));
}

std::optional<AtlasImpact> ImpactStore::find(const FemProblem& problem) const {
  const std::string key = key_of(problem);
  std::optional<MemberResult> member;
  {
    const std::lock_guard lock(guard_);
    member = store_.find(key);
  }
  if (!member) return std::nullopt;
  return impact_of(std::move(*member), problem);
}

void ImpactStore::keep(const FemProblem& problem, const AtlasImpact& impact) const {
  const KeptMember member{.key = key_of(problem), .factors = "{}", .result = member_of(impact)};
  const std::lock_guard lock(guard_);
  store_.keep({member});
}

}  // namespace rebound

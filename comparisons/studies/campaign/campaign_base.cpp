#include "comparisons/studies/campaign/campaign_base.hpp"

#include <algorithm>
#include <fstream>
#include <limits>
#include <sstream>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/studies/campaign/content_bytes.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

MemberResult result_of(const ImpactScalars& s, const Closures& closures, double momentum) {
  return {.scalars = {s.restitution, s.contact_time, s.contact_time_1pct, s.peak_force,
                      s.peak_deflection, s.mean_deflection, s.rebound_speed, closures.impulse,
                      closures.energy, momentum}};
}

enum class Keep { scalars, trace };

std::vector<TraceColumn> columns_of(Trace trace) {
  std::vector<TraceColumn> columns = {{"time_s", std::move(trace.time)},
                                      {"force_N", std::move(trace.force)},
                                      {"deflection_m", std::move(trace.deflection)}};
  for (TraceColumn& column : trace.further) columns.push_back(std::move(column));
  return columns;
}

template <class Result>
MemberResult kept_of(Result&& result, double momentum, Keep keep) {
  MemberResult member = result_of(result.scalars, result.closures, momentum);
  if (keep == Keep::trace) member.trace = columns_of(std::move(result.trace));
  return member;
}

MemberResult run_problem(const LumpedProblem& problem, Keep keep, const RunControl&) {
  return kept_of(simulate(problem), std::numeric_limits<double>::quiet_NaN(), keep);
}

MemberResult run_problem(const FemProblem& problem, Keep keep, const RunControl& control) {
  const Mesh mesh = mesh_for(problem, control, worker_threads());
  FemResult result = fem_tier().simulate(problem, mesh, control);
  if (result.incomplete_because.empty())
    return kept_of(std::move(result), result.restitution_momentum, keep);
  if (control.interrupted && control.interrupted())
    throw Error(ExitCode::interrupted, "interrupted");
  return {.failure = result.incomplete_because};
}

std::string key_of(const Campaign& campaign, const std::string& content) {
  return member_key(campaign.program() + "\n" + content);
}

/// A refusal that belongs to the member's input; throws what does not.
std::string refusal_of(const Error& error) {
  if (error.code() != ExitCode::bad_input && error.code() != ExitCode::solver_failed) throw error;
  const std::string& key = error.location().key;
  return key.empty() ? error.what() : key + ": " + error.what();
}

/// What a member does, or why there is nothing to do.
struct PreparedMember final : Campaign::Member {
  MemberWork work;
  std::string refusal;

  MemberResult run(const RunControl& control) const override {
    if (!work) return {.failure = refusal};
    try {
      return work({.interrupted = control.interrupted, .progress = {}});
    } catch (const Error& error) {
      return {.failure = refusal_of(error)};
    }
  }
};

template <class File>
struct ImpactBase final : Campaign::Base {
  File file;  ///< as written: what follows from its numbers is found anew for each member
  std::string mesh_digest;

  explicit ImpactBase(Document read) : Base(std::move(read)) {
    read_document(document, file);
    File complete = file;
    complete_impact(document, complete);
    if constexpr (requires { file.problem.mesh_file; }) {
      if (complete.problem.controls.field_frames > 0)
        throw document.error_at("controls.field_frames", "a campaign keeps scalars, no fields",
                                "0, or absent");
      if (!complete.problem.mesh_file.empty())
        mesh_digest = sha256(bytes_of(complete.problem.mesh_file));
    }
  }

  bool of_impacts() const override { return true; }
  std::vector<Key> numbers() const override { return numbers_of(file); }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override;
};

/// Its file is completed where it is run: a member that is found needs no more than its key.
template <class File>
struct ImpactMember final : Campaign::Member {
  const ImpactBase<File>* base = nullptr;
  File varied;
  Keep keep = Keep::scalars;

  MemberResult run(const RunControl& control) const override {
    try {
      File complete = varied;
      return run_problem(complete_impact(base->document, complete), keep,
                         {.interrupted = control.interrupted, .progress = {}});
    } catch (const Error& error) {
      return {.failure = refusal_of(error)};
    }
  }
};

template <class File>
std::unique_ptr<Campaign::Member> ImpactBase<File>::member(const Campaign& campaign,
                                                           std::vector<double> values) const {
  auto made = std::make_unique<ImpactMember<File>>();
  made->base = this;
  made->varied = file;
  made->keep = campaign.keeps_traces() ? Keep::trace : Keep::scalars;
  const std::string content =
      content_bytes(made->varied, setting(campaign.design().factors, values));
  made->key =
      key_of(campaign, mesh_digest + (campaign.keeps_traces() ? "\ntraces\n" : "\n") + content);
  made->values = std::move(values);
  return made;
}

}  // namespace

bool Campaign::Base::gives(const std::string& path) const {
  return static_cast<bool>(toml::at_path(document.root(), path));
}

std::shared_ptr<const Campaign::Base> read_base(Document document) {
  const toml::table& root = document.root();
  if (root.contains("believed")) return read_diagnosis_base(std::move(document));
  if (root.contains("reference") || root.contains("folders"))
    return read_calibration_base(std::move(document));
  if (root.contains("shot")) return read_synthesis_base(std::move(document));
  if (root["model"]["tier"].value<std::string>() != "fem")
    return std::make_shared<ImpactBase<LumpedImpactFile>>(std::move(document));
  fem_tier();  // loaded before there are threads
  return std::make_shared<ImpactBase<FemImpactFile>>(std::move(document));
}

std::unique_ptr<Campaign::Member> make_member(const Campaign& campaign, const std::string& content,
                                              std::vector<double> values,
                                              const std::function<MemberWork()>& prepare) {
  auto made = std::make_unique<PreparedMember>();
  made->key = key_of(campaign, content);
  made->values = std::move(values);
  try {
    made->work = prepare();
  } catch (const Error& error) {
    made->refusal = refusal_of(error);
  }
  return made;
}

}  // namespace rebound

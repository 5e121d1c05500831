#include "comparisons/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <set>
#include <sstream>

#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/results/provenance.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/describe_lumped.hpp"
#include "comparisons/io/toml/impact_file.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/mesh_for.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/models/installation.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/studies/campaign/each_number.hpp"
#include "lumped/integration/simulate.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

std::string bytes_of(const std::filesystem::path& file) {
  std::ifstream in(file, std::ios::binary);
  std::ostringstream bytes;
  bytes << in.rdbuf();
  if (!in) throw Error(ExitCode::input_output_failed, "cannot be read", {.file = file.string()});
  return bytes.str();
}

MemberResult result_of(const ImpactScalars& s, const Closures& closures, double momentum) {
  return {.scalars = {s.restitution, s.contact_time, s.contact_time_1pct, s.peak_force,
                      s.peak_deflection, s.mean_deflection, s.rebound_speed, closures.impulse,
                      closures.energy, momentum},
          .failure = {}};
}

MemberResult run_problem(const LumpedProblem& problem, const RunControl&) {
  const LumpedResult result = simulate(problem);
  return result_of(result.scalars, result.closures, std::numeric_limits<double>::quiet_NaN());
}

MemberResult run_problem(const FemProblem& problem, const RunControl& control) {
  const RunControl silent{.interrupted = control.interrupted, .progress = {}};
  const Mesh mesh = mesh_for(problem, silent, worker_threads());
  const FemResult result = fem_tier().simulate(problem, mesh, silent);
  if (result.incomplete_because.empty())
    return result_of(result.scalars, result.closures, result.restitution_momentum);
  if (control.interrupted && control.interrupted())
    throw Error(ExitCode::interrupted, "interrupted");
  return {.scalars = {}, .failure = result.incomplete_because};
}

/// A refusal that belongs to the member's input; throws what does not.
std::string refusal_of(const Error& error) {
  if (error.code() != ExitCode::bad_input && error.code() != ExitCode::solver_failed) throw error;
  const std::string& key = error.location().key;
  return key.empty() ? error.what() : key + ": " + error.what();
}

/// An impact with the numbers of one member, or why there is none.
template <class Problem>
struct ImpactMember final : Campaign::Member {
  std::optional<Problem> problem;
  std::string refusal;

  MemberResult run(const RunControl& control) const override {
    if (!problem) return {.scalars = {}, .failure = refusal};
    try {
      return run_problem(*problem, control);
    } catch (const Error& error) {
      return {.scalars = {}, .failure = refusal_of(error)};
    }
  }
};

/// Sets those numbers of `file` whose paths are `factors`.
template <class File>
void set_numbers(File& file, const std::vector<CampaignFactor>& factors,
                 const std::vector<double>& values) {
  const EachNumber::Look look = [&](const std::string& path, const Key&, double& value) {
    for (std::size_t i = 0; i < factors.size(); ++i)
      if (factors[i].key == path) value = values[i];
  };
  EachNumber visitor(look);
  describe(static_cast<Visitor&>(visitor), file);
}

template <class File>
std::vector<Key> numbers_of(const File& file) {
  std::vector<Key> keys;
  const EachNumber::Look look = [&](const std::string& path, const Key& key, double&) {
    keys.push_back(key);
    keys.back().name = path;
  };
  EachNumber visitor(look);
  File copy = file;
  describe(static_cast<Visitor&>(visitor), copy);
  return keys;
}

}  // namespace

struct Campaign::Base {
  explicit Base(Document read) : document(std::move(read)) {}
  virtual ~Base() = default;
  virtual std::vector<Key> numbers() const = 0;
  virtual std::unique_ptr<Member> member(const Campaign& campaign,
                                         std::vector<double> values) const = 0;
  Document document;
};

namespace {

template <class File>
struct BaseOf final : Campaign::Base {
  File file;  ///< as written: what follows from its numbers is found anew for each member
  std::string mesh_digest;

  explicit BaseOf(Document read) : Base(std::move(read)) {
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

  std::vector<Key> numbers() const override { return numbers_of(file); }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override {
    using Problem = decltype(file.problem);
    auto made = std::make_unique<ImpactMember<Problem>>();
    File varied = file;
    set_numbers(varied, campaign.design().factors, values);
    made->key =
        sha256(campaign.program() + "\n" + mesh_digest + "\n" + write_toml(varied)).substr(0, 32);
    made->values = std::move(values);
    try {
      made->problem = complete_impact(document, varied);
    } catch (const Error& error) {
      made->refusal = refusal_of(error);
    }
    return made;
  }
};

std::shared_ptr<const Campaign::Base> read_base(Document document) {
  if (document.root()["model"]["tier"].value<std::string>() != "fem")
    return std::make_shared<BaseOf<LumpedImpactFile>>(std::move(document));
  fem_tier();  // loaded before there are threads
  return std::make_shared<BaseOf<FemImpactFile>>(std::move(document));
}

/// Numbers that stand in the base file; those that it could give are refused by name.
std::vector<Key> given_numbers(const Document& document, const Campaign::Base& base) {
  std::vector<Key> given;
  std::set<std::string> absent;
  for (const Key& key : base.numbers()) {
    if (key.name == "schema") continue;  // no number of the impact
    if (toml::at_path(base.document.root(), key.name))
      given.push_back(key);
    else
      absent.insert(key.name);
  }
  const toml::array* factors = document.root()["design"]["factor"].as_array();
  for (std::size_t i = 0; factors && i < factors->size(); ++i) {
    const auto path = fmt::format("design.factor[{}].key", i);
    if (const auto name = toml::at_path(document.root(), path).value<std::string>();
        name && absent.contains(*name))
      throw document.error_at(path, fmt::format("{} does not give this key: write it there first",
                                                base.document.name()));
  }
  return given;
}

std::filesystem::path base_path(const Document& document) {
  const auto base = document.root()["base"].value<std::string>();
  if (!base || base->empty())
    throw document.error_at("base", "which impact file is varied?", "the path of an impact file");
  return std::filesystem::absolute(document.folder() / *base);
}

}  // namespace

std::string running_program() {
  std::string digest = sha256(bytes_of("/proc/self/exe"));
  if (has_fem_tier()) digest = sha256(digest + sha256(bytes_of(module_file("rebound_fem"))));
  return to_json(Provenance{}).at("version").get<std::string>() + "+" + digest.substr(0, 16);
}

void describe(Visitor& visit, CampaignFile& file) {
  describe_schema(visit);
  visit.text({.name = "base", .sentence = "Impact file of either tier, relative to this file."},
             file.base);
  visit.table({.name = "design", .sentence = "What of it is varied, and how."}, file.design);
}

Campaign Campaign::load(const std::filesystem::path& file) {
  const Document document = Document::load(file);
  const auto base = base_path(document);
  return parse({.file = std::filesystem::absolute(file).string(),
                .text = document.text(),
                .base_file = base.string(),
                .base_text = Document::load(base).text()});
}

Campaign Campaign::parse(CampaignText text) {
  Campaign campaign;
  campaign.text_ = std::move(text);
  const Document document = Document::parse(campaign.text_.text, campaign.text_.file);
  campaign.base_ = read_base(Document::parse(campaign.text_.base_text, campaign.text_.base_file));
  campaign.file_.design.known = given_numbers(document, *campaign.base_);
  read_document(document, campaign.file_);
  check_design(document, campaign.file_.design);
  campaign.program_ = running_program();
  return campaign;
}

std::unique_ptr<Campaign::Member> Campaign::member(std::vector<double> values) const {
  return base_->member(*this, std::move(values));
}

std::string Campaign::digest() const {
  return sha256(sha256(text_.text) + sha256(text_.base_text));
}

CampaignMembers make_members(const Campaign& campaign, DesignSampler& sampler,
                             const std::vector<std::size_t>& numbers) {
  std::vector<std::vector<double>> values;
  values.reserve(numbers.size());
  for (const std::size_t number : numbers) values.push_back(sampler.at(number));
  CampaignMembers members(numbers.size());
  in_parallel(members.size(),
              [&](std::size_t i) { members[i] = campaign.member(std::move(values[i])); });
  return members;
}

}  // namespace rebound

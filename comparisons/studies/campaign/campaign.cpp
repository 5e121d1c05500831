#include "comparisons/studies/campaign/campaign.hpp"

#include <fmt/format.h>

#include <set>

#include "comparisons/io/result_store/running_program.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/toml/describe_impact.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/models/parallel/in_parallel.hpp"
#include "comparisons/studies/campaign/campaign_base.hpp"
#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

/// Numbers that stand in the base file; those that it could give are refused by name.
std::vector<Key> given_numbers(const Document& document, const Campaign::Base& base) {
  std::vector<Key> given;
  std::set<std::string> absent;
  for (const Key& key : base.numbers()) {
    if (key.name == "schema") continue;  // no number of the model
    if (base.gives(key.name))
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
    throw document.error_at("base", "which file is varied?",
                            "the path of an impact, synthesis, calibration or diagnosis file");
  return std::filesystem::absolute(document.folder() / *base);
}

}  // namespace

void describe(Visitor& visit, CampaignFile& file) {
  describe_schema(visit);
  visit.text(
      {.name = "base",
       .sentence = "Impact, synthesis, calibration or diagnosis file, relative to this one."},
      file.base);
  visit.flag({.name = "traces",
              .sentence = "Keep the trace of every impact in the store, compressed.",
              .presence = Presence::optional},
             file.traces);
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
  if (campaign.file_.traces && !campaign.base_->of_impacts())
    throw document.error_at("traces", "only impacts have traces", "false, or absent");
  campaign.program_ = running_program();
  return campaign;
}

std::unique_ptr<Campaign::Member> Campaign::member(std::vector<double> values) const {
  return base_->member(*this, std::move(values));
}

bool Campaign::of_impacts() const {
  return base_->of_impacts();
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

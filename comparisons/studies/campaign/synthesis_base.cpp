#include <fmt/format.h>

#include <algorithm>

#include "comparisons/discrepancy/synthesis/synthesize.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/studies/campaign/campaign_base.hpp"

namespace rebound {
namespace {

/// What happened in a shot, then what was measured of it.
void add_shot(const std::string& name, const HiddenShot& hidden, const MeasuredImpact& measured,
              std::vector<NamedValue>& values) {
  const auto add = [&](const char* what, double value) {
    values.push_back({.name = name + "." + what, .value = value});
  };
  const ImpactScalars& s = hidden.scalars;
  add("speed_m_s", hidden.speed);
  add("restitution", s.restitution);
  add("contact_time_s", s.contact_time);
  add("contact_time_1pct_s", s.contact_time_1pct);
  add("peak_force_N", s.peak_force);
  add("peak_deflection_m", s.peak_deflection);
  add("mean_deflection_m", s.mean_deflection);
  add("rebound_speed_m_s", s.rebound_speed);
  if (measured.restitution.value) add("measured_restitution", *measured.restitution.value);
  if (measured.contact_time.value) add("measured_contact_time_s", *measured.contact_time.value);
  const std::vector<double>& force = measured.trace.force;
  if (!force.empty()) add("measured_peak_force_N", *std::max_element(force.begin(), force.end()));
}

MemberResult result_of(const Synthesis& made) {
  MemberResult result;
  result.values = {{.name = "true_mass_kg", .value = made.true_mass},
                   {.name = "true_force_gain", .value = made.true_force_gain}};
  for (std::size_t i = 0; i < made.hidden.size(); ++i)
    add_shot(fmt::format("shot-{:02}", i + 1), made.hidden[i], made.dataset.shots[i],
             result.values);
  return result;
}

struct SynthesisBase final : Campaign::Base {
  SynthesisFile file;  ///< as written
  std::string mesh_digest;

  explicit SynthesisBase(Document read)
      : Base(std::move(read)), file(read_uncompleted_synthesis(document)) {
    SynthesisFile complete = file;
    complete_synthesis(document, complete);
    if (!complete.fem.mesh_file.empty()) mesh_digest = sha256(bytes_of(complete.fem.mesh_file));
    if (file.tier == Tier::fem) fem_tier();  // loaded before there are threads
  }

  std::vector<Key> numbers() const override { return numbers_of(file); }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override {
    SynthesisFile varied = file;
    set_numbers(varied, campaign.design().factors, values);
    return make_member(
        campaign, "synthesis\n" + mesh_digest + "\n" + write_toml(varied), std::move(values),
        [&]() -> MemberWork {
          complete_synthesis(document, varied);
          return [varied](const RunControl& control) {
            return result_of(synthesize(varied, simulator_of(varied, control), control));
          };
        });
  }
};

}  // namespace

std::shared_ptr<const Campaign::Base> read_synthesis_base(Document document) {
  return std::make_shared<SynthesisBase>(std::move(document));
}

}  // namespace rebound

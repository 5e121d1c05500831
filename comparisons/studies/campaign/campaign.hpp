#pragma once

#include <array>
#include <filesystem>
#include <memory>
#include <string>
#include <variant>
#include <vector>

#include "comparisons/io/toml/document.hpp"
#include "comparisons/studies/campaign/campaign_design.hpp"
#include "lumped/problem/run_control.hpp"

namespace rebound {

/// What `rebound campaign FILE` reads: a file that is varied, and what of it is.
struct CampaignFile {
  std::string base;  ///< impact, synthesis, calibration or diagnosis; relative to the campaign file
  CampaignDesign design;
};

void describe(Visitor& visit, CampaignFile& file);

/// Scalars that are kept of an impact, by their names in files.
inline constexpr std::array<const char*, 10> member_scalars{
    "restitution",       "contact_time_s",      "contact_time_1pct_s", "peak_force_N",
    "peak_deflection_m", "mean_deflection_m",   "rebound_speed_m_s",   "impulse_closure",
    "energy_closure",    "restitution_momentum"};

/// A number or a text that a member gave, by its name in a table; NaN is no number.
struct NamedValue {
  std::string name;
  std::variant<double, std::string> value;
};

/// What one member gave: an impact its scalars, any other member values with names of their own. A
/// member that has no result says why, and that is its result: the same input gives the same
/// refusal.
struct MemberResult {
  std::array<double, member_scalars.size()> scalars{};  ///< NaN: the tier has no such scalar
  std::vector<NamedValue> values{};                     ///< of a member that is no impact
  std::string failure{};                                ///< empty: it ran
};

/// What a campaign was made of, to be read again without its files.
struct CampaignText {
  std::string file, text;            ///< of the campaign
  std::string base_file, base_text;  ///< of what it varies
};

/// Version and first digits of the digest of the program that runs, with the FE module's: results
/// of two programs are not mixed. Errors: Error(input_output_failed).
std::string running_program();

/// A campaign: members by number, each a file with other numbers in it.
///
/// A member is what `rebound lumped`, `fem`, `synthesize`, `calibrate` or `diagnose` gives on such
/// a file, to the same bits -> tests CampaignCommand.AMemberIsTheImpactOfItsFile, CampaignBases.
class Campaign {
 public:
  /// Errors: Error(bad_input) with file, line and key, of either file.
  static Campaign load(const std::filesystem::path& file);
  static Campaign parse(CampaignText text);

  /// A member ready to be run, and the key of its result: SHA-256, cut to 128 bits, over the
  /// effective file, the digests of the files it reads and the version of the program.
  class Member {
   public:
    virtual ~Member() = default;
    /// Errors: Error(interrupted), Error(input_output_failed); any other refusal is a result.
    virtual MemberResult run(const RunControl& control) const = 0;
    std::string key;
    std::vector<double> values;  ///< of the factors [SI]
  };
  /// May be called from several threads at once.
  std::unique_ptr<Member> member(std::vector<double> values) const;

  const CampaignDesign& design() const { return file_.design; }
  const CampaignText& text() const { return text_; }
  std::string digest() const;  ///< of the texts of both files
  std::size_t size() const { return member_count(file_.design); }
  const std::string& program() const { return program_; }

  bool of_impacts() const;  ///< do its members give scalars, or values with names?

  struct Base;  ///< the file that is varied

 private:
  CampaignText text_;
  CampaignFile file_;
  std::string program_;
  std::shared_ptr<const Base> base_;
};

using CampaignMembers = std::vector<std::unique_ptr<Campaign::Member>>;

/// Members of a design by their numbers, made by all threads.
CampaignMembers make_members(const Campaign& campaign, DesignSampler& sampler,
                             const std::vector<std::size_t>& numbers);

}  // namespace rebound

#include "comparisons/inference/calibration/calibration_file.hpp"
#include "comparisons/inference/calibration/material_calibration_file.hpp"
#include "comparisons/io/results/digest.hpp"
#include "comparisons/io/toml/describe_fem.hpp"
#include "comparisons/io/toml/reader.hpp"
#include "comparisons/io/toml/toml_writer.hpp"
#include "comparisons/models/fem_access/module_loader.hpp"
#include "comparisons/studies/campaign/campaign_base.hpp"

namespace rebound {
namespace {

MemberResult result_of(const CalibrationResult& fit) {
  MemberResult result;
  const auto add = [&](const std::string& name, double value) {
    result.values.push_back({.name = name, .value = value});
  };
  for (const Estimate& estimate : fit.estimates) {
    add(estimate.name, estimate.value);
    add(estimate.name + ".low", estimate.low);
    add(estimate.name + ".high", estimate.high);
    result.values.push_back({.name = estimate.name + ".identifiability",
                             .value = std::string(name_of(estimate.identifiability))});
  }
  add("cost_after", fit.cost_after);
  add("reduced_chi_square", fit.reduced_chi_square);
  add("data", fit.data);
  add("evaluations", fit.evaluations);
  add("converged", fit.converged ? 1.0 : 0.0);
  return result;
}

/// Of a law: the data are read once, whatever the members.
struct LawCalibrationBase final : Campaign::Base {
  CalibrationFile file;
  std::vector<MeasuredImpact> shots;
  std::string data_digest;

  explicit LawCalibrationBase(Document read) : Base(std::move(read)) {
    read_document(document, file);
    for (const ReferenceFolder& reference : file.references)
      data_digest += digest_of_folder(document.folder() / reference.folder) + "\n";
    shots = references_of(document, file);
  }

  std::vector<Key> numbers() const override { return numbers_of(file); }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override {
    CalibrationFile varied = file;
    set_numbers(varied, campaign.design().factors, values);
    return make_member(
        campaign, "calibration\n" + data_digest + write_toml(varied), std::move(values),
        [&]() -> MemberWork {
          return [this, varied](const RunControl& control) {
            return result_of(calibrate(varied.request, shots, varied.options, control).fit);
          };
        });
  }
};

/// Of a material. The data are read for each member: their assumed uncertainties may be varied.
struct MaterialCalibrationBase final : Campaign::Base {
  MaterialCalibrationFile file;
  std::string data_digest;

  explicit MaterialCalibrationBase(Document read) : Base(std::move(read)) {
    read_document(document, file);
    for (const std::string& folder : file.folders)
      data_digest += digest_of_folder(document.folder() / folder) + "\n";
    const FemProblem start = read_input(document, file).start;
    data_digest += write_toml(start) + "\n";
    if (!start.mesh_file.empty()) data_digest += sha256(bytes_of(start.mesh_file)) + "\n";
    fem_tier();  // loaded before there are threads
  }

  std::vector<Key> numbers() const override { return numbers_of(file); }

  std::unique_ptr<Campaign::Member> member(const Campaign& campaign,
                                           std::vector<double> values) const override {
    MaterialCalibrationFile varied = file;
    set_numbers(varied, campaign.design().factors, values);
    return make_member(
        campaign, "material calibration\n" + data_digest + write_toml(varied), std::move(values),
        [&]() -> MemberWork {
          return [this, varied](const RunControl& control) {
            return result_of(
                calibrate_material(varied, read_input(document, varied), control).found.fit);
          };
        });
  }
};

}  // namespace

std::shared_ptr<const Campaign::Base> read_calibration_base(Document document) {
  if (document.root()["tier"].value<std::string>() == "fem")
    return std::make_shared<MaterialCalibrationBase>(std::move(document));
  return std::make_shared<LawCalibrationBase>(std::move(document));
}

}  // namespace rebound

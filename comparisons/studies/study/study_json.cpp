#include "comparisons/studies/study/study_json.hpp"

#include "comparisons/discrepancy/error_rates/error_rates_output.hpp"
#include "comparisons/inference/references/scalar_errors_json.hpp"
#include "comparisons/studies/study/believed_simulation.hpp"
#include "comparisons/studies/study/joint_json.hpp"

namespace rebound {
namespace {

Json measured_json(const MeasuredImpact& shot) {
  return {{"speed_m_s", shot.impact.speed},
          {"restitution", number_or_null(shot.restitution.value)},
          {"contact_time_s", number_or_null(shot.contact_time.value)},
          {"mean_deflection_m", number_or_null(shot.mean_deflection.value)}};
}

Json shot_json(const StudyShot& shot) {
  return {{"measured", measured_json(shot.measured)},
          {"fem", to_json(shot.fem)},
          {"fem_contact_time_above_threshold_s", shot.contact_time},
          {"fem_coarse", to_json(shot.fem_coarse)}};
}

Json cell_json(const LawScore& cell) {
  if (!cell.failure.empty()) return {{"failure", cell.failure}};
  return {{"restitution", cell.scalars.restitution},
          {"contact_time_s", cell.scalars.contact_time},
          {"peak_force_N", cell.scalars.peak_force},
          {"peak_deflection_m", cell.scalars.peak_deflection},
          {"mean_deflection_m", cell.scalars.mean_deflection},
          {"error_against_fem", to_json(cell.against_reference)},
          {"error_against_measurement", to_json(cell.against_measured)},
          {"force_time_rms_of_peak", cell.force_time_rms},
          {"force_deflection_rms_of_peak", cell.force_deflection_rms}};
}

Json law_json(const StudyLaw& law, const std::vector<LawScore>& cells) {
  Json at_speed = Json::array();
  for (const auto& at : law.model.at_speed)
    at_speed.push_back({{"speed_m_s", at.speed}, {"parameters", at.parameters}});
  Json scores = Json::array();
  for (const auto& cell : cells) scores.push_back(cell_json(cell));
  return {{"label", law.label},   {"origin", law.origin},
          {"law", law.model.law}, {"parameters", law.model.parameters},
          {"at_speed", at_speed}, {"fit", law.fit ? fit_json(*law.fit) : Json(nullptr)},
          {"scores", scores}};
}

Json consistency_json(const ConsistencyFit& one, const Observations& all) {
  Json ratios = Json::array();
  for (const ObservableRatio& ratio : one.ratios) {
    Json of_shots = Json::array();
    for (std::size_t i = 0; i < ratio.of_shots.size(); ++i)
      of_shots.push_back({{"speed_m_s", all.shots[i].impact.speed},
                          {"measured_over_modelled", number_or_null(ratio.of_shots[i])}});
    ratios.push_back({{"observable", key_of(ratio.what)},
                      {"mean", ratio.mean},
                      {"scatter", ratio.scatter},
                      {"shots", of_shots}});
  }
  return {{"left_out", one.left_out ? Json(key_of(*one.left_out)) : Json(nullptr)},
          {"reduced_chi_square", one.fit.reduced_chi_square()},
          {"observables", ratios}};
}

Json gap_json(const ScalarGap& gap) {
  return {{"fitted", gap.fitted}, {"unseen", number_or_null(gap.unseen)}};
}

Json scalars_json(const ScalarDiagnosis& d) {
  Json fits = Json::array({consistency_json(d.consistency.all, d.all)}), effects = Json::array();
  for (const ConsistencyFit& one : d.consistency.without)
    fits.push_back(consistency_json(one, d.all));
  for (const EffectOnScalars& one : d.effects)
    effects.push_back({{"effect", one.effect.name},
                       {"family", name_of(one.family)},
                       {"size", one.effect.size},
                       {"parameters", parameters_json(one.effect)},
                       {"reduced_chi_square", one.reduced_chi_square},
                       {"information_criterion", one.information_criterion}});
  return {{"fits", fits},
          {"unseen_speed_m_s", number_or_null(d.unseen_speed)},
          {"gap_before", gap_json(d.believed)},
          {"gap_after", gap_json(d.extended)},
          {"earns_a_name", earns_a_name(d)},
          {"effects", effects},
          {"cells", d.cells},
          {"finer_cells", d.finer_cells}};
}

Json core_json(const CoreStudy& core) {
  Json shots = Json::array();
  for (const auto& shot : core.shots) shots.push_back(shot_json(shot));
  Json laws = Json::array();
  for (std::size_t i = 0; i < core.laws.size(); ++i)
    laws.push_back(law_json(core.laws[i], core.benchmark.cells[i]));
  return {{"label", core.label},
          {"data", core.data.name},
          {"long_term_modulus_Pa", core.long_term_modulus},
          {"long_term_modulus_hertz_Pa", core.long_term_modulus_hertz},
          {"material_fit", fit_json(core.material.fit)},
          {"shots", shots},
          {"laws", laws},
          {"diagnosis", json_with_error_rates(core.diagnosis)},
          {"simulation", core.scalars ? scalars_json(*core.scalars) : Json(nullptr)}};
}

}  // namespace

Json fit_json(const CalibrationResult& fit) {
  Json estimates = Json::array();
  for (const auto& estimate : fit.estimates)
    estimates.push_back({{"name", estimate.name},
                         {"unit", estimate.unit},
                         {"value", estimate.value},
                         {"interval", {estimate.low, estimate.high}},
                         {"verdict", estimate.verdict}});
  return {{"estimates", estimates},         {"reduced_chi_square", fit.reduced_chi_square},
          {"cost_before", fit.cost_before}, {"cost_after", fit.cost_after},
          {"converged", fit.converged},     {"evaluations", fit.evaluations},
          {"verdict", fit.verdict},         {"warnings", fit.warnings}};
}

Json study_json(const StudyFile& study, const std::vector<CoreStudy>& cores,
                const std::optional<JointScalars>& joint,
                const std::vector<ExperimentStudy>& experiments) {
  Json list = Json::array(), synthetic = Json::array();
  for (const auto& core : cores) list.push_back(core_json(core));
  for (const auto& experiment : experiments)
    synthetic.push_back({{"label", experiment.label},
                         {"hidden", experiment.hidden},
                         {"diagnosis", json_with_error_rates(experiment.diagnosis)}});
  return {{"schema", 1},
          {"title", study.title},
          {"cores", list},
          {"joint_simulation", joint ? joint_json(cores, *joint) : Json(nullptr)},
          {"experiments", synthetic}};
}

}  // namespace rebound

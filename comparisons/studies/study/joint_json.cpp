#include "comparisons/studies/study/joint_json.hpp"

#include "comparisons/studies/study/believed_simulation.hpp"

namespace rebound {
namespace {

using Labels = std::vector<const CoreStudy*>;

Json fit_of_all_json(const JointConsistencyFit& fit, const Labels& cores) {
  Json observables = Json::array();
  for (const JointRatio& ratio : fit.ratios) {
    Json of_cores = Json::array();
    for (std::size_t i = 0; i < cores.size(); ++i)
      of_cores.push_back({{"label", cores[i]->label},
                          {"measured_over_modelled", number_or_null(ratio.of_balls[i])}});
    observables.push_back({{"observable", key_of(ratio.what)},
                           {"mean", ratio.mean},
                           {"scatter_of_cores", ratio.scatter_of_balls},
                           {"scatter_of_shots", ratio.scatter_of_shots},
                           {"cores", of_cores}});
  }
  return {{"left_out", fit.left_out ? Json(key_of(*fit.left_out)) : Json(nullptr)},
          {"reduced_chi_square", fit.reduced_chi_square},
          {"observables", observables}};
}

Json common_factor_json(const CommonFactor& common) {
  return {{"observable", key_of(common.what)},
          {"factor", common.factor},
          {"reduced_chi_square", common.reduced_chi_square}};
}

Json gap_of_all_json(const JointGap& gap, const Labels& cores) {
  Json of_cores = Json::array();
  for (std::size_t i = 0; i < gap.unseen_of_balls.size(); ++i)
    of_cores.push_back({{"label", cores[i]->label}, {"unseen", gap.unseen_of_balls[i]}});
  return {
      {"fitted", gap.all.fitted}, {"unseen", number_or_null(gap.all.unseen)}, {"cores", of_cores}};
}

Json variant_json(const JointVariant& variant, const Labels& cores) {
  Json of_cores = Json::array();
  for (std::size_t i = 0; i < cores.size(); ++i)
    of_cores.push_back({{"label", cores[i]->label},
                        {"size", variant.of_balls[i].size},
                        {"youngs_modulus_Pa", variant.materials[i].youngs_modulus},
                        {"parameters", parameters_json(variant.of_balls[i])}});
  return {{"in_common", name_of(variant.in_common)},
          {"numbers", variant.numbers},
          {"chi_square", variant.chi_square},
          {"information_criterion", variant.information_criterion},
          {"gap", gap_of_all_json(variant.gap, cores)},
          {"cores", of_cores}};
}

Json effect_of_all_json(const JointEffect& effect, const Labels& cores) {
  Json variants = Json::array();
  for (const JointVariant& variant : effect.variants)
    variants.push_back(variant_json(variant, cores));
  return {{"effect", effect.name}, {"family", name_of(effect.family)}, {"variants", variants}};
}

}  // namespace

std::string key_of(ObservedQuantity what) {
  for (const ScalarQuantity& scalar : scalar_quantities)
    if (scalar.what == what) return scalar.key;
  return name_of(what);
}

Json parameters_json(const EffectChoice& effect) {
  Json parameters = Json::array();
  for (const auto& [name, value] : effect.parameters)
    parameters.push_back({{"name", name}, {"value", value}});
  return parameters;
}

Json joint_json(const std::vector<CoreStudy>& all_cores, const JointScalars& joint) {
  const Labels cores = diagnosed_cores(all_cores);
  Json labels = Json::array(), effects = Json::array();
  for (const CoreStudy* core : cores) labels.push_back(core->label);
  Json fits = Json::array({fit_of_all_json(joint.consistency.all, cores)});
  for (const JointConsistencyFit& fit : joint.consistency.without)
    fits.push_back(fit_of_all_json(fit, cores));
  for (const JointEffect& effect : joint.effects.effects)
    effects.push_back(effect_of_all_json(effect, cores));
  const auto& common = joint.consistency.common_factor;
  return {{"cores", labels},
          {"fits", fits},
          {"common_factor", common ? common_factor_json(*common) : Json(nullptr)},
          {"unseen_speed_m_s", number_or_null(joint.unseen_speed)},
          {"gap_before", gap_of_all_json(joint.believed(), cores)},
          {"gap_after", gap_of_all_json(joint.extended(), cores)},
          {"earns_a_name", joint.earns_a_name()},
          {"error_scale", joint.effects.scale},
          {"effects", effects}};
}

}  // namespace rebound

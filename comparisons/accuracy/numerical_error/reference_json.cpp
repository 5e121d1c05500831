#include "comparisons/accuracy/numerical_error/reference_json.hpp"

namespace rebound {

Json to_json(const ReferenceImpact& reference) {
  Json json = to_json(reference.result);
  for (const ScalarError& error : reference.errors) {
    json["uncertainty"][error.key] = error.uncertainty;
    const auto& order = error.meshes.observed_order;
    json["uncertainty_basis"][error.key] = {
        {"method",
         error.meshes.basis == ErrorBasis::grid_convergence ? "grid-convergence-index" : "spread"},
        {"order", number_or_null(order)},
        {"meshes", error.meshes.uncertainty},
        {"step", error.step},
        {"scatter", error.scatter}};
  }
  json["reference"] = {{"limit", reference_limit},
                       {"beyond", beyond_reference_limit(reference)},
                       {"contact_nodes", reference.contact_nodes}};
  json["model_form"] = nullptr;
  if (reference.model_form) {
    json["model_form"] = {{"relaxation", name_of(reference.model_form->other)}};
    for (std::size_t i = 0; i < reference.errors.size(); ++i)
      json["model_form"]["difference"][reference.errors[i].key] =
          reference.model_form->difference[i];
  }
  json["family"] = Json::array();
  for (const FamilyMember& member : reference.family)
    json["family"].push_back({{"cells", member.cells},
                              {"speed_m_s", member.speed},
                              {"step_safety", member.step_safety},
                              {"steps", member.steps},
                              {"wall_s", member.wall_seconds}});
  return json;
}

}  // namespace rebound

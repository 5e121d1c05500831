#include "comparisons/inference/references/scalar_errors_json.hpp"

namespace rebound {

Json to_json(const ScalarErrors& errors) {
  return {{"peak_force", number_or_null(errors.peak_force)},
          {"peak_deflection", number_or_null(errors.peak_deflection)},
          {"mean_deflection", number_or_null(errors.mean_deflection)},
          {"contact_time", number_or_null(errors.contact_time)},
          {"contact_time_1pct", number_or_null(errors.contact_time_1pct)},
          {"restitution", number_or_null(errors.restitution)}};
}

}  // namespace rebound

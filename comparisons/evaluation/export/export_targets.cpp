#include "comparisons/evaluation/export/deck_writers.hpp"

namespace rebound {

const std::vector<ExportTarget>& export_targets() {
  static const std::string own_elements =
      "elements, contact and time steps are the code's own, on the mesh of this problem";
  static const std::vector<ExportTarget> list = {
      {"calculix",
       ".inp",
       "CalculiX",
       "**",
       {CarriedPhysics::gravity},
       {own_elements, "contact by a penalty instead of exactly"},
       calculix_deck},
  };
  return list;
}

}  // namespace rebound

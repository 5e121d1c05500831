#include "comparisons/evaluation/export/deck_writers.hpp"

namespace rebound {

const std::vector<ExportTarget>& export_targets() {
  static const std::string own_elements =
      "elements, contact and time steps are the code's own, on the mesh of this problem";
  static const std::string penalty = "contact by a penalty instead of exactly";
  static const std::string not_run = "this deck's form is checked, it has not been run by its code";
  static const std::vector<ExportTarget> list = {
      {"calculix",
       ".inp",
       "CalculiX",
       "**",
       {CarriedPhysics::gravity},
       {own_elements, penalty},
       calculix_deck},
      {"abaqus",
       ".inp",
       "Abaqus/Explicit",
       "**",
       {CarriedPhysics::relaxation, CarriedPhysics::friction, CarriedPhysics::gravity},
       {own_elements, not_run},
       abaqus_deck},
      {"febio",
       ".feb",
       "FEBio 4",
       "",
       {CarriedPhysics::relaxation},
       {own_elements, penalty, not_run},
       febio_deck},
      {"ls-dyna",
       ".k",
       "LS-DYNA",
       "$",
       {CarriedPhysics::relaxation, CarriedPhysics::friction, CarriedPhysics::gravity},
       {own_elements, not_run},
       lsdyna_deck},
      {"fenicsx",
       ".py",
       "FEniCSx 0.5",
       "#",
       {CarriedPhysics::relaxation, CarriedPhysics::gravity},
       {own_elements, penalty},
       fenicsx_deck},
  };
  return list;
}

}  // namespace rebound

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "comparisons/evaluation/export/solid_card.hpp"
#include "fem/interface/fem_problem.hpp"
#include "meshes/mesh.hpp"

namespace rebound {

/// Physics of an FE problem beyond elastic law, inertia and a rigid smooth plate.
enum class CarriedPhysics { relaxation, friction, gravity };

/// An impact in the terms in which every deck needs it.
struct ImpactToExport {
  const FemProblem& problem;
  const Mesh& mesh;       ///< bilinear cells, plate at z = 0
  SolidCard solid;        ///< density of the meshed body left at 0: the target sets it
  double end_time = 0.0;  ///< [s]
  double interval = 0.0;  ///< of the output [s]
  double penalty = 0.0;   ///< pressure per overclosure, where a code has a penalty [Pa/m]
};

/// What a target makes of it.
struct DeckBody {
  std::string text;
  std::vector<std::string> differences;  ///< carried otherwise than here, a sentence each
  int nodes = 0, elements = 0;           ///< of the ball
};

/// One code that decks are written for.
struct ExportTarget {
  const char* name;       ///< of --to
  const char* extension;  ///< of the file
  const char* code;       ///< and how the deck cuts the ball up
  const char* comment;    ///< begins a line of comment; empty: XML
  std::vector<CarriedPhysics> carries;
  std::vector<std::string> always_different;  ///< whatever the problem
  DeckBody (*write)(const ImpactToExport& impact);
};

/// CalculiX, Abaqus, FEBio, LS-DYNA, FEniCSx: one file each.
const std::vector<ExportTarget>& export_targets();

}  // namespace rebound

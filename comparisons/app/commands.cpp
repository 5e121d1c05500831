#include "comparisons/app/commands.hpp"

namespace rebound {

const std::vector<Command>& commands() {
  static const std::vector<Command> table{
      {"study", "the main job: data in, report out", declare_study},
      {"reproduce", "the seed paper's numbers, value by value, against published", declare_reproduce},
      {"lumped", "one trace of a lumped contact law", declare_lumped},
      {"fem", "one trace of the FE tier", declare_fem},
      {"compress", "slow or prescribed compression of the FE tier, no inertia", declare_compress},
      {"mesh", "the sphere mesh, with quality figures", declare_mesh},
      {"calibrate", "a lumped law's parameters to traces, with uncertainty", declare_calibrate},
      {"benchmark", "lumped laws against reference traces: one scored matrix", declare_benchmark},
      {"atlas", "where each law holds, against FE, with its error", declare_atlas},
      {"select", "which law the traces speak for, if they tell", declare_select},
      {"convert", "a contact's parameters in the conventions of other codes, with the error", declare_convert},
      {"drop", "restitution in the regulation's drop test, with its interval", declare_drop},
      {"verify", "known answers against what this program returns, with observed orders", declare_verify},
      {"synthesize", "a synthetic experiment with something hidden in it", declare_synthesize},
      {"diagnose", "where model and data disagree, and which effect is missing", declare_diagnose},
      {"init", "commented files to start from", declare_init},
      {"schema", "JSON schema of a file format", declare_schema},
      {"doctor", "versions, folders, and a tiny run of each tier", declare_doctor},
  };
  return table;
}

}  // namespace rebound

#include "comparisons/discrepancy/consistency/joint_scalars.hpp"

namespace rebound {

JointScalars diagnose_jointly(const std::vector<const ScalarDiagnosis*>& apart,
                              const RunControl& control) {
  std::vector<const ObservableConsistency*> consistency;
  std::vector<const FitsOfEffects*> fits;
  JointScalars joint;
  joint.unseen_speed = apart.front()->unseen_speed;
  for (const ScalarDiagnosis* one : apart) {
    consistency.push_back(&one->consistency);
    fits.push_back(&one->fits);
    if (one->unseen_speed != joint.unseen_speed) joint.unseen_speed.reset();
  }
  joint.consistency = compare_jointly(consistency, control);
  joint.effects = try_effects_jointly(fits, control);
  return joint;
}

}  // namespace rebound

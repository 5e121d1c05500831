#pragma once

namespace rebound {

/// What a contact remembers that is no continuous state. It changes at
/// instants that an integrator locates, and is constant between them.
struct ContactPhase {
  enum class Kind {
    loading,  ///< deeper than ever before, or nothing remembers how deep
    below,    ///< less deep than the largest approach so far
    pulled,   ///< apart, and still pulled together
    open,     ///< apart, and may touch again
  };
  bool apart() const { return kind == Kind::pulled || kind == Kind::open; }

  Kind kind = Kind::loading;
  double largest = 0.0;  ///< approach where loading last ended [m]
};

}  // namespace rebound

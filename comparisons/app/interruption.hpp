#pragma once

namespace rebound {

/// From now on SIGINT and SIGTERM ask the running command to stop and keep
/// what is complete. A second signal ends the program at once.
/// A limit on file sizes then shows as a failed write.
void watch_for_interruption();

/// Has a signal asked to stop?
bool interrupted();

}  // namespace rebound

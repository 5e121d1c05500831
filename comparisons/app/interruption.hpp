#pragma once

#include "comparisons/app/session.hpp"

namespace rebound {

/// From now on SIGINT and SIGTERM ask the running command to stop and keep
/// what is complete. A second signal ends the program at once.
/// A limit on file sizes then shows as a failed write.
///
/// Limit:   a phase that does not look, as the set-up of a large mesh, keeps nothing that could be
///          complete: it is ended within a second, by exit code 130 and the message of `format`.
///          One that looked in the last seconds is waited for, and the reader told so.
///          -> test ASetUpIsInterruptedWithinASecond
/// Caution: takes SIGALRM.
void watch_for_interruption(OutputFormat format);

/// Has a signal asked to stop?
bool interrupted();

}  // namespace rebound

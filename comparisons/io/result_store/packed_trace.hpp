#pragma once

#include <string>
#include <vector>

#include "comparisons/io/result_store/stored_member.hpp"

namespace rebound {

/// A trace as bytes, without loss: the same bits come back.
///
/// Columns one after the other; of each, first bytes of all numbers, then second bytes, …, so that
/// the slowly changing ones lie together; then zlib, level 6. Numbers as the machine has them,
/// which Debian's processors have in one order. Limit:  bits come back, those of NaN and -0 among
/// them -> test PackedTraceTest.TheSameBitsComeBack Source: byte shuffling as HDF5's filter of that
/// name; zlib (RFC 1950).
std::string packed(const std::vector<TraceColumn>& trace);

/// Errors: Error(corrupt_store) for bytes that packed() did not make.
std::vector<TraceColumn> unpacked(const std::string& bytes);

}  // namespace rebound

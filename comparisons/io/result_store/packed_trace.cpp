#include "comparisons/io/result_store/packed_trace.hpp"

#include <zlib.h>

#include <cstdint>
#include <cstring>

#include "lumped/problem/error.hpp"

namespace rebound {
namespace {

constexpr std::size_t width = sizeof(double);
/// More than any trace has: what says more is no trace.
constexpr std::uint64_t most_bytes = std::uint64_t{1} << 32U;

Error damaged() {
  return {ExitCode::corrupt_store, "a stored trace is damaged"};
}

void add_number(std::string& bytes, std::uint64_t value) {
  bytes.append(reinterpret_cast<const char*>(&value), sizeof value);
}

/// Takes pieces off the beginning.
class Taker {
 public:
  explicit Taker(const std::string& bytes) : bytes_(bytes) {}
  std::uint64_t number() {
    std::uint64_t value = 0;
    std::memcpy(&value, take(sizeof value), sizeof value);
    return value;
  }
  const char* take(std::size_t count) {
    if (count > bytes_.size() - at_) throw damaged();
    at_ += count;
    return bytes_.data() + at_ - count;
  }
  std::size_t left() const { return bytes_.size() - at_; }

 private:
  const std::string& bytes_;
  std::size_t at_ = 0;
};

void add_shuffled(std::string& bytes, const std::vector<double>& values) {
  const auto* from = reinterpret_cast<const char*>(values.data());
  const std::size_t start = bytes.size(), count = values.size();
  bytes.resize(start + count * width);
  for (std::size_t b = 0; b < width; ++b)
    for (std::size_t i = 0; i < count; ++i) bytes[start + b * count + i] = from[i * width + b];
}

std::vector<double> unshuffled(const char* from, std::size_t count) {
  std::vector<double> values(count);
  auto* to = reinterpret_cast<char*>(values.data());
  for (std::size_t b = 0; b < width; ++b)
    for (std::size_t i = 0; i < count; ++i) to[i * width + b] = from[b * count + i];
  return values;
}

}  // namespace

std::string packed(const std::vector<TraceColumn>& trace) {
  std::string plain;
  add_number(plain, trace.size());
  for (const TraceColumn& column : trace) {
    add_number(plain, column.name.size());
    plain += column.name;
    add_number(plain, column.values.size());
    add_shuffled(plain, column.values);
  }
  uLongf size = compressBound(plain.size());
  std::string bytes;
  add_number(bytes, plain.size());
  const std::size_t head = bytes.size();
  bytes.resize(head + size);
  constexpr int level = 6;
  const int status = compress2(reinterpret_cast<Bytef*>(bytes.data() + head), &size,
                               reinterpret_cast<const Bytef*>(plain.data()), plain.size(), level);
  if (status != Z_OK) throw Error(ExitCode::input_output_failed, "a trace cannot be compressed");
  bytes.resize(head + size);
  return bytes;
}

std::vector<TraceColumn> unpacked(const std::string& bytes) {
  Taker outer(bytes);
  uLongf size = outer.number();
  if (size > most_bytes || size > 2000 * (bytes.size() + 1))
    throw damaged();  // zlib's best is 1032
  std::string plain(size, '\0');
  const std::size_t left = outer.left();
  if (uncompress(reinterpret_cast<Bytef*>(plain.data()), &size,
                 reinterpret_cast<const Bytef*>(outer.take(left)), left) != Z_OK ||
      size != plain.size())
    throw damaged();
  Taker inner(plain);
  std::vector<TraceColumn> trace;
  for (std::uint64_t columns = inner.number(); columns > 0; --columns) {
    TraceColumn& column = trace.emplace_back();
    const std::uint64_t letters = inner.number();
    column.name.assign(inner.take(letters), letters);
    const std::uint64_t count = inner.number();
    if (count > inner.left() / width) throw damaged();
    column.values = unshuffled(inner.take(count * width), count);
  }
  if (inner.left() > 0) throw damaged();
  return trace;
}

}  // namespace rebound

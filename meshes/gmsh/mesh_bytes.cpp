#include "meshes/gmsh/mesh_bytes.hpp"

#include <cstring>
#include <type_traits>
#include <vector>

namespace rebound {
namespace {

class Sender {
 public:
  template <class Number>
  void add(const std::vector<Number>& numbers) {
    static_assert(std::is_trivially_copyable_v<Number>);
    add_block(numbers.data(), numbers.size() * sizeof(Number));
  }
  void add(const std::string& text) { add_block(text.data(), text.size()); }
  std::string bytes() && { return std::move(bytes_); }

 private:
  void add_block(const void* data, std::size_t size) {
    bytes_.append(reinterpret_cast<const char*>(&size), sizeof size);
    if (size > 0) bytes_.append(static_cast<const char*>(data), size);
  }
  std::string bytes_;
};

class Receiver {
 public:
  explicit Receiver(std::string_view bytes) : rest_(bytes) {}

  template <class Number>
  void take(std::vector<Number>& numbers) {
    const std::string_view block = take_block();
    numbers.resize(block.size() / sizeof(Number));
    if (!block.empty()) std::memcpy(numbers.data(), block.data(), block.size());
  }
  std::string text() { return std::string(take_block()); }
  int number() {
    std::vector<int> one;
    take(one);
    return one.at(0);
  }

 private:
  std::string_view take_block() {
    std::size_t size = 0;
    if (rest_.size() >= sizeof size) std::memcpy(&size, rest_.data(), sizeof size);
    if (rest_.size() < sizeof size || rest_.size() - sizeof size < size)
      throw Error(ExitCode::bad_input, "Gmsh ended before it was done");
    const std::string_view block = rest_.substr(sizeof size, size);
    rest_.remove_prefix(sizeof size + size);
    return block;
  }
  std::string_view rest_;
};

}  // namespace

std::string bytes_of(const Mesh& mesh) {
  Sender sender;
  sender.add(mesh.vertices);
  sender.add(mesh.cells);
  sender.add(mesh.axis_edges);
  sender.add(mesh.contact_edges);
  sender.add(mesh.regions);
  sender.add(std::vector<int>{static_cast<int>(mesh.region_names.size())});
  for (const std::string& name : mesh.region_names) sender.add(name);
  return std::move(sender).bytes();
}

Mesh mesh_of(std::string_view bytes) {
  Receiver receiver(bytes);
  Mesh mesh;
  receiver.take(mesh.vertices);
  receiver.take(mesh.cells);
  receiver.take(mesh.axis_edges);
  receiver.take(mesh.contact_edges);
  receiver.take(mesh.regions);
  for (int left = receiver.number(); left > 0; --left) mesh.region_names.push_back(receiver.text());
  return mesh;
}

std::string bytes_of(const Error& error) {
  const ErrorLocation& at = error.location();
  Sender sender;
  sender.add(std::vector<int>{static_cast<int>(error.code())});
  sender.add(std::vector<int>{at.line});
  for (const std::string& text : {std::string(error.what()), at.file, at.key, at.value, at.allowed})
    sender.add(text);
  return std::move(sender).bytes();
}

Error error_of(std::string_view bytes) {
  Receiver receiver(bytes);
  const auto code = static_cast<ExitCode>(receiver.number());
  ErrorLocation at{.line = receiver.number()};
  const std::string message = receiver.text();
  for (std::string* text : {&at.file, &at.key, &at.value, &at.allowed}) *text = receiver.text();
  return Error(code, message, at);
}

}  // namespace rebound

// Runs a fuzz target on files and folders: how the kept corpus is part of the tests, with any
// compiler. usage: replay_NAME FILE-OR-FOLDER...
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <vector>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size);

int main(int count, char** arguments) {
  int files = 0;
  const auto replay = [&](const std::filesystem::path& file) {
    std::ifstream in(file, std::ios::binary);
    const std::vector<char> bytes{std::istreambuf_iterator<char>(in), {}};
    LLVMFuzzerTestOneInput(reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size());
    ++files;
  };
  for (int i = 1; i < count; ++i) {
    const std::filesystem::path given = arguments[i];
    if (!std::filesystem::is_directory(given)) {
      replay(given);
      continue;
    }
    for (const auto& entry : std::filesystem::directory_iterator(given)) replay(entry.path());
  }
  std::cout << files << " inputs\n";
  return files > 0 ? 0 : 1;
}

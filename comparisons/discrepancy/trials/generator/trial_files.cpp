#include "comparisons/discrepancy/trials/generator/trial_files.hpp"

#include <fmt/format.h>
#include <openssl/evp.h>
#include <openssl/rand.h>
#include <unistd.h>

#include <array>
#include <fstream>
#include <span>
#include <utility>

namespace trials {
namespace {

std::string hexadecimal(std::span<const unsigned char> bytes) {
  std::string digits;
  for (const unsigned char byte : bytes) digits += fmt::format("{:02x}", byte);
  return digits;
}

void make_folder(const std::filesystem::path& folder) {
  std::error_code status;
  std::filesystem::create_directories(folder, status);
  if (status)
    throw FileError(
        fmt::format("cannot make the folder {}: {}", folder.string(), status.message()));
}

}  // namespace

std::string fresh_nonce() {
  std::array<unsigned char, 32> bytes{};
  if (RAND_bytes(bytes.data(), static_cast<int>(bytes.size())) != 1)
    throw FileError("the system gives no random numbers for a nonce");
  return hexadecimal(bytes);
}

std::string sha256(const std::string& bytes) {
  std::array<unsigned char, 32> digest{};
  unsigned int length = 0;
  if (EVP_Digest(bytes.data(), bytes.size(), digest.data(), &length, EVP_sha256(), nullptr) != 1)
    throw FileError("SHA-256 failed");
  return hexadecimal(digest);
}

void write_whole(const std::filesystem::path& file, const std::string& text) {
  auto temporary = file;
  temporary += fmt::format(".{}.tmp", ::getpid());
  std::error_code status;
  {
    std::ofstream stream(temporary, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream) {
      std::filesystem::remove(temporary, status);
      throw FileError(fmt::format("cannot write {}", temporary.string()));
    }
  }
  std::filesystem::rename(temporary, file, status);
  if (status) throw FileError(fmt::format("cannot write {}: {}", file.string(), status.message()));
}

TrialFolder::TrialFolder(std::filesystem::path folder) : folder_(std::move(folder)) {
  make_folder(folder_ / "truth");
  make_folder(folder_ / "trials");
}

void TrialFolder::add(const Trial& trial) {
  const std::string number = fmt::format("{:04}", trial.request.number);
  const std::string truth = truth_text(trial, fresh_nonce());
  write_whole(folder_ / "truth" / (number + ".json"), truth);
  seals_ += fmt::format("{}  truth/{}.json\n", sha256(truth), number);
  write_whole(folder_ / "sealed.txt", seals_);
  const auto data = folder_ / "trials" / number;
  make_folder(data);
  for (std::size_t i = 0; i < trial.shots.size(); ++i)
    write_whole(data / fmt::format("shot-{:02}.csv", i + 1), csv_text(trial.shots[i]));
  write_whole(data / "model.toml", model_text(trial));
  // Last: where dataset.toml stands, the rest is complete.
  write_whole(data / "dataset.toml", dataset_text(trial));
}

}  // namespace trials

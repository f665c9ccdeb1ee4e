#include "digest.hpp"

#include <array>
#include <cstdio>
#include <memory>
#include <vector>

#include <fmt/format.h>
#include <openssl/evp.h>

namespace hybridfusion {
namespace {

class Sha256 {
 public:
  Sha256() : context_(EVP_MD_CTX_new(), &EVP_MD_CTX_free) {
    HF_CHECK(context_ && EVP_DigestInit_ex(context_.get(), EVP_sha256(), nullptr) == 1);
  }
  void add(const void* bytes, std::size_t size) {
    HF_CHECK(EVP_DigestUpdate(context_.get(), bytes, size) == 1);
  }
  [[nodiscard]] std::string hex() {
    std::array<unsigned char, EVP_MAX_MD_SIZE> digest{};
    unsigned int size = 0;
    HF_CHECK(EVP_DigestFinal_ex(context_.get(), digest.data(), &size) == 1);
    std::string text;
    for (unsigned int i = 0; i < size; ++i) text += fmt::format("{:02x}", digest[i]);
    return text;
  }

 private:
  std::unique_ptr<EVP_MD_CTX, decltype(&EVP_MD_CTX_free)> context_;
};

}  // namespace

std::string sha256_of(std::string_view bytes) {
  Sha256 digest;
  digest.add(bytes.data(), bytes.size());
  return digest.hex();
}

Expected<std::string> sha256_of_file(const std::filesystem::path& path) {
  const std::unique_ptr<std::FILE, int (*)(std::FILE*)> file(std::fopen(path.c_str(), "rb"),
                                                             &std::fclose);
  if (!file) {
    return fail(
        ErrorCode::kNotFound,
        fmt::format("{}: cannot be opened; check the path and its permissions", path.string()));
  }
  Sha256 digest;
  std::vector<char> buffer(1U << 20U);
  while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), file.get())) {
    digest.add(buffer.data(), size);
  }
  if (std::ferror(file.get()) != 0) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: reading stopped early; check the disk", path.string()));
  }
  return digest.hex();
}

}  // namespace hybridfusion

#include "output_file.hpp"

#include <cerrno>
#include <cstring>

namespace hybridfusion {

Expected<OutputFile> OutputFile::create(const std::filesystem::path& path) {
  OutputFile file;
  file.path_ = path;
  file.stream_.open(path, std::ios::binary | std::ios::trunc);
  if (!file.stream_) {
    return fail(ErrorCode::kIo, "cannot write '" + path.string() + "': " + std::strerror(errno));
  }
  return file;
}

void OutputFile::rewrite(std::uint64_t offset, std::string_view bytes) {
  stream_.seekp(static_cast<std::streamoff>(offset));
  stream_.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  stream_.seekp(static_cast<std::streamoff>(position_));
}

Expected<void> OutputFile::close() {
  stream_.close();
  if (stream_.fail()) {
    return fail(ErrorCode::kIo,
                "writing '" + path_.string() + "' failed after " + std::to_string(position_) +
                    " bytes; is the disk full?");
  }
  return {};
}

Expected<void> write_whole_file(const std::filesystem::path& path, std::string_view bytes) {
  HF_TRY(OutputFile file, OutputFile::create(path));
  file.write(bytes);
  return file.close();
}

}  // namespace hybridfusion

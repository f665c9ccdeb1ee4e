#include "recording_reader.hpp"

#include "text.hpp"
#include "zstd_stream.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

[[nodiscard]] Container container_of_bytes(std::span<const std::byte> start) {
  const std::string_view text(reinterpret_cast<const char*>(start.data()), start.size());
  if (text.starts_with("\x89MCAP")) return Container::kMcap;
  return text.starts_with("SQLite format 3") ? Container::kSqlite : Container::kRosbag1;
}

Expected<std::vector<std::byte>> first_bytes(const std::filesystem::path& path) {
  constexpr std::uint64_t kBytes = std::uint64_t{1} << 16;
  HF_TRY(InputFile file, InputFile::open(path));
  HF_TRY(const auto bytes, file.take(std::min(kBytes, file.size())));
  return std::vector<std::byte>(bytes.begin(), bytes.end());
}

/// Bags and folders of ROS 2 bags that lie in a folder, by name.
[[nodiscard]] std::vector<std::string> recordings_in(const std::filesystem::path& folder) {
  std::vector<std::string> names;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string name = entry->path().filename().string();
    std::error_code ignored;
    if (lower_case(name).ends_with(".bag") ||
        std::filesystem::exists(entry->path() / "metadata.yaml", ignored)) {
      names.push_back(name);
    }
  }
  std::ranges::sort(names);
  return names;
}

Expected<Container> container_of_folder(const std::filesystem::path& folder) {
  bool scans = false;
  std::error_code code;
  for (std::filesystem::directory_iterator entry(folder, code), end; !code && entry != end;
       entry.increment(code)) {
    const std::string name = lower_case(entry->path().filename().string());
    if (name == "metadata.yaml" || name.ends_with(".db3") || name.ends_with(".mcap")) {
      return Container::kRos2Folder;
    }
    scans = scans || name == "imu.csv" || name.ends_with(".pcd");
  }
  if (scans) return Container::kScanFolder;
  if (const auto inside = recordings_in(folder); !code && !inside.empty()) {
    return fail(ErrorCode::kParse,
                fmt::format("{}: a folder of recordings: {}; give {}",
                            folder.string(),
                            printable(fmt::format("{}", fmt::join(inside, ", "))),
                            inside.size() == 1 ? "this one itself" : "one of these"));
  }
  return fail(code ? ErrorCode::kIo : ErrorCode::kParse,
              fmt::format("{}: {}; give a ROS 1 bag, a ROS 2 bag (folder, .db3 or .mcap) or a "
                          "folder with the scans as .pcd files and, where there is one, imu.csv",
                          folder.string(),
                          code ? code.message() : "a folder without a recording"));
}

}  // namespace

Expected<Container> container_of(const std::filesystem::path& path) {
  std::error_code code;
  if (std::filesystem::is_directory(path, code)) return container_of_folder(path);
  HF_TRY(const std::vector<std::byte> start, first_bytes(path));
  if (!is_zstd(start)) return container_of_bytes(start);
  ZstdStream stream;
  std::span<const std::byte> packed = start;
  return container_of_bytes(stream.unpack(packed));
}

Expected<MessageFile::Reader> MessageFile::open_reader(const std::filesystem::path& path,
                                                       const std::filesystem::path& name) {
  HF_TRY(const std::vector<std::byte> start, first_bytes(path));
  switch (container_of_bytes(start)) {
    case Container::kMcap: {
      HF_TRY(McapFile file, McapFile::open(path, name));
      HF_TRY(auto reader, MessageMerger<McapFile>::create(std::move(file)));
      return Reader(std::move(reader));
    }
    case Container::kSqlite: {
      HF_TRY(SqliteBag reader, SqliteBag::open(path, name));
      return Reader(std::move(reader));
    }
    default: {
      HF_TRY(Rosbag1Reader reader, Rosbag1Reader::open(path, name));
      return Reader(std::move(reader));
    }
  }
}

Expected<MessageFile> MessageFile::open(const std::filesystem::path& path,
                                        const RecordingSetup& setup) {
  HF_TRY(const std::vector<std::byte> start, first_bytes(path));
  if (!is_zstd(start)) {
    HF_TRY(Reader reader, open_reader(path, path));
    return MessageFile(std::move(reader));
  }
  HF_TRY(UnpackedFile unpacked, unpack_zstd_file(path, setup.scratch_folder, setup.context));
  HF_TRY(const std::filesystem::path name, unpacked.file.give_name());
  HF_TRY(Reader reader, open_reader(name, path));
  unpacked.file.drop_name();
  MessageFile file(std::move(reader));
  file.compressed_ = true;
  if (!unpacked.problem.empty()) {
    file.cut_ = fmt::format("{}: {}; what precedes is used", path.string(), unpacked.problem);
  }
  return file;
}

std::string MessageFile::format() const {
  constexpr std::array<std::string_view, 3> kNames = {
      "ROS 1 bag 2.0", "ROS 2 bag (sqlite3)", "MCAP"};
  return std::string(kNames[reader_.index()]) + (compressed_ ? ", zstd" : "");
}

const std::vector<BagConnection>& MessageFile::connections() const {
  return std::visit(
      [](const auto& reader) -> const std::vector<BagConnection>& { return reader.connections(); },
      reader_);
}

void MessageFile::select_topics(const std::vector<std::string>& topics) {
  std::visit([&](auto& reader) { reader.select_topics(topics); }, reader_);
}

Expected<std::optional<BagMessage>> MessageFile::next() {
  return std::visit([](auto& reader) { return reader.next(); }, reader_);
}

bool MessageFile::truncated() const {
  return !cut_.empty() ||
         std::visit([](const auto& reader) { return reader.truncated(); }, reader_);
}

std::vector<std::string> MessageFile::warnings() const {
  std::vector<std::string> warnings =
      std::visit([](const auto& reader) { return reader.warnings(); }, reader_);
  if (!cut_.empty()) warnings.push_back(cut_);
  return warnings;
}

Expected<RecordingReader> open_recording_reader(const std::filesystem::path& path,
                                                Container container,
                                                const RecordingSetup& setup) {
  HF_CHECK(container != Container::kScanFolder);
  if (container == Container::kRos2Folder) {
    HF_TRY(Ros2Bag bag, Ros2Bag::open(path, setup));
    return RecordingReader(std::move(bag));
  }
  HF_TRY(MessageFile file, MessageFile::open(path, setup));
  return RecordingReader(std::move(file));
}

}  // namespace hybridfusion

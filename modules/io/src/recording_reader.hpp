#pragma once

#include "mcap_file.hpp"
#include "message_merger.hpp"
#include "scratch_file.hpp"
#include "sqlite_bag.hpp"

#include <hybridfusion/core/run_context.hpp>
#include <hybridfusion/io/rosbag1.hpp>

#include <variant>

namespace hybridfusion {

/// What kind of recording a path is.
enum class Container : std::uint8_t { kRosbag1, kSqlite, kMcap, kRos2Folder, kScanFolder };

/// By the first bytes of a file (of the unpacked bytes when it is compressed) or the content of a
/// folder; a file of no known kind counts as a ROS 1 bag, whose reader then says what is wrong.
/// @returns kNotFound for a missing path; kParse for a folder that holds no recording.
[[nodiscard]] Expected<Container> container_of(const std::filesystem::path& path);

/// What reading needs beside the recording.
struct RecordingSetup {
  std::filesystem::path scratch_folder = {};  ///< For unpacking.
  RunContext context = {};                    ///< Stops and reports unpacking.
};

/// One file of messages, in any container, compressed as a whole or not.
class MessageFile {
 public:
  [[nodiscard]] static Expected<MessageFile> open(const std::filesystem::path& path,
                                                  const RecordingSetup& setup);

  [[nodiscard]] std::string format() const;
  [[nodiscard]] const std::vector<BagConnection>& connections() const;
  void select_topics(const std::vector<std::string>& topics);
  [[nodiscard]] Expected<std::optional<BagMessage>> next();
  [[nodiscard]] bool truncated() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  using Reader = std::variant<Rosbag1Reader, SqliteBag, MessageMerger<McapFile>>;

  explicit MessageFile(Reader reader) : reader_(std::move(reader)) {}
  [[nodiscard]] static Expected<Reader> open_reader(const std::filesystem::path& path,
                                                    const std::filesystem::path& name);

  Reader reader_;
  std::string cut_ = {};  ///< Why the compressed file is not complete; empty when it is.
  bool compressed_ = false;
};

/// The folder of a ROS 2 bag: metadata.yaml, if there, and its files one after the other.
class Ros2Bag {
 public:
  /// @returns kParse for damaged metadata or a folder without bag files, and what MessageFile says.
  [[nodiscard]] static Expected<Ros2Bag> open(const std::filesystem::path& folder,
                                              const RecordingSetup& setup);

  [[nodiscard]] const std::string& format() const { return format_; }
  [[nodiscard]] const std::vector<BagConnection>& connections() const { return connections_; }
  void select_topics(const std::vector<std::string>& topics) { topics_ = topics; }
  [[nodiscard]] Expected<std::optional<BagMessage>> next();
  [[nodiscard]] bool truncated() const;
  [[nodiscard]] std::vector<std::string> warnings() const;

 private:
  [[nodiscard]] Expected<void> open_next_file();
  void add_connections(const MessageFile& file);
  /// Takes over what the current file has to say, before it is closed.
  void close_file();

  RecordingSetup setup_ = {};
  std::vector<std::filesystem::path> files_ = {};
  std::size_t next_file_ = 0;
  std::optional<MessageFile> file_ = {};
  std::vector<BagConnection> connections_ = {};
  std::vector<std::string> topics_ = {};
  bool truncated_ = false;
  std::string format_ = {};
  std::vector<std::string> warnings_ = {};
};

/// The files of the folder of a ROS 2 bag that are read.
[[nodiscard]] Expected<std::vector<std::filesystem::path>> ros2_bag_files(
    const std::filesystem::path& folder);

using RecordingReader = std::variant<MessageFile, Ros2Bag>;

/// @pre container is not kScanFolder
[[nodiscard]] Expected<RecordingReader> open_recording_reader(const std::filesystem::path& path,
                                                              Container container,
                                                              const RecordingSetup& setup);

}  // namespace hybridfusion

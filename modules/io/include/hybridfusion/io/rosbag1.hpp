#pragma once

#include <hybridfusion/core/error.hpp>
#include <hybridfusion/core/time.hpp>
#include <hybridfusion/io/ros_wire.hpp>

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace hybridfusion {

struct BagConnection {
  std::uint32_t id = 0;
  std::string topic = {};
  std::string type = {};                       ///< "sensor_msgs/Imu"
  std::optional<std::uint64_t> messages = {};  ///< Absent when the bag has no index.
  RosWire wire = RosWire::kRos1;
};

struct BagMessage {
  std::uint32_t connection = 0;          ///< BagConnection::id.
  Timestamp time{};                      ///< When it was recorded.
  std::span<const std::byte> data = {};  ///< Serialised message, kept alive by `storage`.
  std::shared_ptr<const std::vector<std::byte>> storage = {};
};

/// Streams a ROS 1 bag (format 2.0; chunks uncompressed, bz2 or lz4), with or without its index. A
/// few chunks are in memory at a time. A damaged chunk is skipped; after a truncation everything
/// before it is recovered. Sizes are checked before memory is taken.
class Rosbag1Reader {
 public:
  /// @param name  What messages call the file; empty: its path.
  /// @returns kNotFound; kParse for an empty file or one that is not a ROS 1 bag 2.0.
  [[nodiscard]] static Expected<Rosbag1Reader> open(const std::filesystem::path& path,
                                                    const std::filesystem::path& name = {});

  Rosbag1Reader(Rosbag1Reader&&) noexcept;
  Rosbag1Reader& operator=(Rosbag1Reader&&) noexcept;
  ~Rosbag1Reader();

  /// Known at this moment: all of them when the bag has an index, else those met in the part of the
  /// bag that open() looked at and next() has read.
  [[nodiscard]] const std::vector<BagConnection>& connections() const;
  /// Only messages of these topics are delivered (default: all). To be called before next().
  void select_topics(std::vector<std::string> topics);
  /// Ordered by recording time as far as neighbouring chunks allow; nothing at the end.
  [[nodiscard]] Expected<std::optional<BagMessage>> next();

  [[nodiscard]] bool truncated() const;
  [[nodiscard]] const std::vector<std::string>& warnings() const;

 private:
  struct State;
  explicit Rosbag1Reader(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion

#pragma once

/// @file
/// Makes small ROS 1 bags for tests, written from the format's description, independent of the
/// reader.

#include <chrono>
#include <cstdint>
#include <cstring>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <bzlib.h>
#include <lz4frame.h>

namespace hybridfusion::testing {

template <class T>
void put(std::string& out, T value) {
  char bytes[sizeof(T)];
  std::memcpy(bytes, &value, sizeof(T));
  out.append(bytes, sizeof(T));
}

inline void put_string(std::string& out, std::string_view text) {
  put(out, static_cast<std::uint32_t>(text.size()));
  out += text;
}

template <class T>
[[nodiscard]] std::string as_bytes(T value) {
  std::string out;
  put(out, value);
  return out;
}

[[nodiscard]] inline std::string bag_time(std::int64_t ns) {
  return as_bytes(static_cast<std::uint32_t>(ns / 1'000'000'000)) +
         as_bytes(static_cast<std::uint32_t>(ns % 1'000'000'000));
}

using Fields = std::vector<std::pair<std::string, std::string>>;

[[nodiscard]] inline std::string bag_fields(const Fields& fields) {
  std::string out;
  for (const auto& [name, value] : fields) put_string(out, name + "=" + value);
  return out;
}

[[nodiscard]] inline std::string bag_record(const Fields& fields, std::string_view data) {
  std::string out;
  put_string(out, bag_fields(fields));
  put_string(out, data);
  return out;
}

[[nodiscard]] inline std::string packed(std::string_view compression, std::string data) {
  if (compression == "bz2") {
    std::string out(data.size() + data.size() / 100 + 600, '\0');
    auto size = static_cast<unsigned>(out.size());
    BZ2_bzBuffToBuffCompress(
        out.data(), &size, data.data(), static_cast<unsigned>(data.size()), 9, 0, 30);
    out.resize(size);
    return out;
  }
  if (compression == "lz4") {
    std::string out(LZ4F_compressFrameBound(data.size(), nullptr), '\0');
    out.resize(LZ4F_compressFrame(out.data(), out.size(), data.data(), data.size(), nullptr));
    return out;
  }
  return data;
}

/// Collects messages into chunks; finish() gives the bytes of the bag.
class BagBuilder {
 public:
  explicit BagBuilder(std::string compression = "none") : compression_(std::move(compression)) {}

  [[nodiscard]] std::uint32_t add_topic(const std::string& topic, const std::string& type) {
    const auto id = static_cast<std::uint32_t>(connections_.size());
    connections_.push_back(bag_record({{"op", "\x07"}, {"conn", as_bytes(id)}, {"topic", topic}},
                                      bag_fields({{"topic", topic},
                                                  {"type", type},
                                                  {"md5sum", std::string(32, '*')},
                                                  {"message_definition", "..."}})));
    return id;
  }

  void add_message(std::uint32_t connection, std::int64_t time_ns, std::string_view data) {
    if (counts_.empty()) start_ns_ = time_ns;
    if (!counts_.contains(connection)) chunk_ += connections_[connection];
    start_ns_ = std::min(start_ns_, time_ns);
    ++counts_[connection];
    chunk_ += bag_record(
        {{"op", "\x02"}, {"conn", as_bytes(connection)}, {"time", bag_time(time_ns)}}, data);
  }

  void end_chunk() {
    if (counts_.empty()) return;
    chunk_positions_.push_back(kRecordsBegin + records_.size());
    const std::uint64_t position = chunk_positions_.back();
    std::string counts;
    for (const auto& [connection, count] : counts_) {
      put(counts, connection);
      put(counts, count);
    }
    infos_ += bag_record({{"op", "\x06"},
                          {"ver", as_bytes(std::uint32_t{1})},
                          {"chunk_pos", as_bytes(position)},
                          {"start_time", bag_time(start_ns_)},
                          {"end_time", bag_time(start_ns_)},
                          {"count", as_bytes(static_cast<std::uint32_t>(counts_.size()))}},
                         counts);
    records_ += bag_record({{"op", "\x05"},
                            {"compression", compression_},
                            {"size", as_bytes(static_cast<std::uint32_t>(chunk_.size()))}},
                           packed(compression_, chunk_));
    chunk_.clear();
    counts_.clear();
  }

  /// Byte offsets of the chunks so far.
  [[nodiscard]] const std::vector<std::uint64_t>& chunk_positions() const {
    return chunk_positions_;
  }

  enum class Index { kWritten, kMissing };
  [[nodiscard]] std::string finish(Index index = Index::kWritten) {
    end_chunk();
    const bool indexed = index == Index::kWritten;
    const std::uint64_t index_position = indexed ? kRecordsBegin + records_.size() : 0;
    std::string header;
    put_string(
        header,
        bag_fields(
            {{"op", "\x03"},
             {"index_pos", as_bytes(index_position)},
             {"conn_count", as_bytes(static_cast<std::uint32_t>(connections_.size()))},
             {"chunk_count", as_bytes(static_cast<std::uint32_t>(chunk_positions_.size()))}}));
    std::string bag = "#ROSBAG V2.0\n" + header;
    put_string(bag, std::string(kRecordsBegin - bag.size() - sizeof(std::uint32_t), ' '));
    bag += records_;
    if (indexed) {
      for (const std::string& connection : connections_) bag += connection;
      bag += infos_;
    }
    return bag;
  }

 private:
  static constexpr std::size_t kRecordsBegin = 13 + 4096;  // as rosbag pads its header

  std::string compression_;
  std::vector<std::string> connections_ = {};
  std::vector<std::uint64_t> chunk_positions_ = {};
  std::map<std::uint32_t, std::uint32_t> counts_ = {};
  std::int64_t start_ns_ = 0;
  std::string chunk_ = {};
  std::string records_ = {};
  std::string infos_ = {};
};

[[nodiscard]] inline std::string ros_header(std::int64_t stamp_ns,
                                            std::string_view frame = "frame") {
  std::string out = as_bytes(std::uint32_t{0}) + bag_time(stamp_ns);
  put_string(out, frame);
  return out;
}

[[nodiscard]] inline std::string imu_message(std::int64_t stamp_ns,
                                             double gyro_x,
                                             double accel_z,
                                             std::string_view frame = "frame") {
  std::string out = ros_header(stamp_ns, frame);
  for (int i = 0; i < 4 + 9; ++i) put(out, 0.0);
  for (const double value : {gyro_x, 0.0, 0.0}) put(out, value);
  for (int i = 0; i < 9; ++i) put(out, 0.0);
  for (const double value : {0.0, 0.0, accel_z}) put(out, value);
  for (int i = 0; i < 9; ++i) put(out, 0.0);
  return out;
}

[[nodiscard]] inline std::string fix_message(std::int64_t stamp_ns,
                                             double latitude_deg,
                                             std::int8_t status,
                                             double variance) {
  std::string out = ros_header(stamp_ns);
  put(out, status);
  put(out, std::uint16_t{1});
  for (const double value : {latitude_deg, 11.5, 520.0}) put(out, value);
  for (int i = 0; i < 9; ++i) put(out, i % 4 == 0 ? variance : 0.0);
  put(out, std::uint8_t{2});
  return out;
}

struct TestField {
  std::string name;
  std::uint8_t datatype;  ///< sensor_msgs/PointField: 2 uint8, 4 uint16, 6 uint32, 7 float, 8
                          ///< double; PCL: 9 int64, 10 uint64, 11 bool
};

/// PointCloud2 of packed fields; values[point][field].
[[nodiscard]] inline std::string cloud_message(std::int64_t stamp_ns,
                                               const std::vector<TestField>& fields,
                                               const std::vector<std::vector<double>>& values,
                                               bool big_endian = false,
                                               std::string_view frame = "frame") {
  constexpr std::uint32_t kSizes[] = {0, 1, 1, 2, 2, 4, 4, 4, 8, 8, 8, 1};
  std::string out = ros_header(stamp_ns, frame);
  put(out, std::uint32_t{1});
  put(out, static_cast<std::uint32_t>(values.size()));
  put(out, static_cast<std::uint32_t>(fields.size()));
  std::uint32_t step = 0;
  for (const TestField& field : fields) {
    put_string(out, field.name);
    put(out, step);
    put(out, field.datatype);
    put(out, std::uint32_t{1});
    step += kSizes[field.datatype];
  }
  std::string data;
  for (const std::vector<double>& point : values) {
    for (std::size_t f = 0; f < fields.size(); ++f) {
      std::string bytes;
      switch (fields[f].datatype) {
        case 2:
        case 11:
          put(bytes, static_cast<std::uint8_t>(point[f]));
          break;
        case 4:
          put(bytes, static_cast<std::uint16_t>(point[f]));
          break;
        case 6:
          put(bytes, static_cast<std::uint32_t>(point[f]));
          break;
        case 7:
          put(bytes, static_cast<float>(point[f]));
          break;
        case 9:
          put(bytes, static_cast<std::int64_t>(point[f]));
          break;
        case 10:
          put(bytes, static_cast<std::uint64_t>(point[f]));
          break;
        default:
          put(bytes, point[f]);
          break;
      }
      if (big_endian) bytes.assign(bytes.rbegin(), bytes.rend());
      data += bytes;
    }
  }
  put(out, static_cast<std::uint8_t>(big_endian));
  put(out, step);
  put(out, static_cast<std::uint32_t>(step * values.size()));
  put_string(out, data);
  put(out, std::uint8_t{1});
  return out;
}

struct LivoxPoint {
  std::uint32_t offset_ns;
  float x;
  float y;
  float z;
  std::uint8_t reflectivity;
  std::uint8_t tag;
  std::uint8_t line;
};

[[nodiscard]] inline std::string livox_message(std::int64_t stamp_ns,
                                               const std::vector<LivoxPoint>& points,
                                               std::uint8_t lidar_id = 0) {
  std::string out = ros_header(stamp_ns);
  put(out, static_cast<std::uint64_t>(stamp_ns));
  put(out, static_cast<std::uint32_t>(points.size()));
  out += static_cast<char>(lidar_id) + std::string(3, '\0');
  put(out, static_cast<std::uint32_t>(points.size()));
  for (const LivoxPoint& point : points) {
    put(out, point.offset_ns);
    for (const float value : {point.x, point.y, point.z}) put(out, value);
    for (const std::uint8_t value : {point.reflectivity, point.tag, point.line}) put(out, value);
  }
  return out;
}

}  // namespace hybridfusion::testing

#include "recording_editor.hpp"

#include "bag_builder.hpp"

#include <hybridfusion/io/rosbag1.hpp>

#include <fstream>
#include <map>
#include <stdexcept>

namespace hybridfusion::testing {
namespace {

constexpr std::size_t kStampAt = 4;  // behind the header's sequence number
constexpr std::int64_t kNsPerSecond = 1'000'000'000;

template <class T>
T value_at(const std::string& bytes, std::size_t at) {
  T value{};
  std::memcpy(&value, bytes.substr(at, sizeof(T)).data(), sizeof(T));
  return value;
}

template <class T>
void put_at(std::string& bytes, std::size_t at, T value) {
  bytes.replace(at, sizeof(T), as_bytes(value));
}

std::size_t end_of_header(const std::string& data) {
  return kStampAt + 12 + value_at<std::uint32_t>(data, kStampAt + 8);
}

/// Where a PointCloud2 keeps what.
struct CloudLayout {
  std::size_t width_at = 0;
  std::map<std::string, std::uint32_t> field_offsets = {};
  std::uint32_t step = 0;
  std::size_t row_step_at = 0;
  std::size_t data_at = 0;
  std::uint32_t data_size = 0;
};

CloudLayout layout_of(const std::string& data) {
  CloudLayout layout;
  std::size_t at = end_of_header(data) + 4;  // behind the height
  layout.width_at = at;
  const auto num_fields = value_at<std::uint32_t>(data, at + 4);
  at += 8;
  for (std::uint32_t i = 0; i < num_fields; ++i) {
    const auto length = value_at<std::uint32_t>(data, at);
    const std::string name = data.substr(at + 4, length);
    at += 4 + length;
    layout.field_offsets[name] = value_at<std::uint32_t>(data, at);
    at += 9;  // offset, datatype, count
  }
  layout.step = value_at<std::uint32_t>(data, at + 1);
  layout.row_step_at = at + 5;
  layout.data_size = value_at<std::uint32_t>(data, at + 9);
  layout.data_at = at + 13;
  return layout;
}

}  // namespace

std::vector<RawMessage> read_messages(const std::filesystem::path& bag) {
  auto reader = Rosbag1Reader::open(bag);
  if (!reader) throw std::runtime_error(reader.error().message);
  std::map<std::uint32_t, BagConnection> connections;
  for (const BagConnection& connection : reader->connections()) {
    connections[connection.id] = connection;
  }
  std::vector<RawMessage> messages;
  for (auto message = reader->next(); message && *message; message = reader->next()) {
    const BagConnection& connection = connections.at((*message)->connection);
    messages.push_back({.topic = connection.topic,
                        .type = connection.type,
                        .recorded_ns = (*message)->time.count(),
                        .data = {reinterpret_cast<const char*>((*message)->data.data()),
                                 (*message)->data.size()}});
  }
  return messages;
}

void write_messages(const std::filesystem::path& bag, const std::vector<RawMessage>& messages) {
  constexpr std::size_t kMessagesPerChunk = 200;
  BagBuilder builder("lz4");
  std::map<std::string, std::uint32_t> connections;
  std::size_t count = 0;
  for (const RawMessage& message : messages) {
    if (!connections.contains(message.topic)) {
      connections[message.topic] = builder.add_topic(message.topic, message.type);
    }
    builder.add_message(connections[message.topic], message.recorded_ns, message.data);
    if (++count % kMessagesPerChunk == 0) builder.end_chunk();
  }
  std::ofstream(bag, std::ios::binary) << builder.finish();
}

std::int64_t stamp_ns(const RawMessage& message) {
  return kNsPerSecond * value_at<std::uint32_t>(message.data, kStampAt) +
         value_at<std::uint32_t>(message.data, kStampAt + 4);
}

void set_stamp(std::int64_t stamp_ns, RawMessage& message) {
  message.data.replace(kStampAt, 8, bag_time(stamp_ns));
}

void edit_imu(RawMessage& message, const std::function<void(ImuValues&)>& edit) {
  // Orientation and its covariance come first, a covariance between the two.
  const std::size_t gyro_at = end_of_header(message.data) + 13 * sizeof(double);
  const std::size_t force_at = gyro_at + 12 * sizeof(double);
  ImuValues values;
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i) * sizeof(double);
    values.angular_velocity[i] = value_at<double>(message.data, gyro_at + at);
    values.specific_force[i] = value_at<double>(message.data, force_at + at);
  }
  edit(values);
  for (Eigen::Index i = 0; i < 3; ++i) {
    const auto at = static_cast<std::size_t>(i) * sizeof(double);
    put_at(message.data, gyro_at + at, values.angular_velocity[i]);
    put_at(message.data, force_at + at, values.specific_force[i]);
  }
}

void edit_rows(RawMessage& message, const std::function<void(std::vector<std::string>&)>& edit) {
  const CloudLayout layout = layout_of(message.data);
  std::vector<std::string> rows;
  for (std::uint32_t at = 0; at + layout.step <= layout.data_size; at += layout.step) {
    rows.push_back(message.data.substr(layout.data_at + at, layout.step));
  }
  edit(rows);
  std::string points;
  for (const std::string& row : rows) points += row;
  const auto size = static_cast<std::uint32_t>(points.size());
  put_at(message.data, layout.width_at, static_cast<std::uint32_t>(rows.size()));
  put_at(message.data, layout.row_step_at, size);
  put_at(message.data, layout.data_at - 4, size);
  message.data.replace(layout.data_at, layout.data_size, points);
}

void edit_field(RawMessage& message,
                const std::string& name,
                const std::function<float(float)>& f) {
  const std::uint32_t offset = layout_of(message.data).field_offsets.at(name);
  edit_rows(message, [&](std::vector<std::string>& rows) {
    for (std::string& row : rows) put_at(row, offset, f(value_at<float>(row, offset)));
  });
}

}  // namespace hybridfusion::testing

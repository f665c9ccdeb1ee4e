#pragma once

/// @file
/// Small flights and recordings for tests of the doctor: healthy as they come, with one mistake
/// each where a test changes a member.

#include "bag_builder.hpp"
#include "sample_photo.hpp"

#include <hybridfusion/core/random.hpp>
#include <hybridfusion/io/jpeg.hpp>
#include <hybridfusion/pipeline/doctor.hpp>
#include <hybridfusion/pipeline/pipeline_options.hpp>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

namespace hybridfusion::testing {

inline constexpr double kSiteLatitude_deg = 48.15;
inline constexpr double kSiteLongitude_deg = 11.5;
inline constexpr double kDegPerMeter = 1.0 / 111200.0;  // of latitude

/// One photo as its file will say.
struct PhotoSpec {
  std::string name = {};
  std::optional<double> latitude_deg = kSiteLatitude_deg;
  double longitude_deg = kSiteLongitude_deg;
  std::optional<double> altitude_m = 600.0;
  int altitude_ref = 0;
  std::optional<double> relative_altitude_m = 80.0;
  bool rtk = true;  ///< Else the accuracy of a code receiver is assumed.
  std::optional<int> focal_35mm = 28;
  int exif_width = 160;
  std::string model = "Camera";
  std::string time = "2026:05:01 10:00:00";
  std::uint64_t texture = 0;
  Image8 image = {};
};

/// Fine random texture, different for each seed.
[[nodiscard]] inline Image8 textured_image(std::uint64_t seed, int width = 160, int height = 120) {
  Image8 image{.width = width, .height = height, .channels = 3};
  Random random(seed, "texture");
  for (int i = 0; i < width * height; ++i) {
    const auto grey = static_cast<std::uint8_t>(40 + random.index(176));
    image.pixels.insert(image.pixels.end(), 3, grey);
  }
  return image;
}

/// Mean over a square of 2 * radius + 1 pixels, clamped at the border.
[[nodiscard]] inline Image8 blurred(const Image8& image, int radius) {
  Image8 result = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < image.channels; ++c) {
        int sum = 0;
        for (int dy = -radius; dy <= radius; ++dy) {
          for (int dx = -radius; dx <= radius; ++dx) {
            const int at_y = std::clamp(y + dy, 0, image.height - 1);
            const int at_x = std::clamp(x + dx, 0, image.width - 1);
            sum += image.pixels[static_cast<std::size_t>(
                (at_y * image.width + at_x) * image.channels + c)];
          }
        }
        result.pixels[static_cast<std::size_t>((y * image.width + x) * image.channels + c)] =
            static_cast<std::uint8_t>(sum / ((2 * radius + 1) * (2 * radius + 1)));
      }
    }
  }
  return result;
}

[[nodiscard]] inline std::string exif_of(const PhotoSpec& photo) {
  constexpr double kScale = 1e7;
  const auto rational = [](double value) {
    return std::pair{static_cast<std::uint32_t>(std::llround(value * kScale)),
                     static_cast<std::uint32_t>(kScale)};
  };
  using Tag = ExifBuilder;
  ExifBuilder exif(std::endian::little);
  exif.text(Tag::kImage, 0x0110, photo.model);
  exif.text(Tag::kPhoto, 0x9003, photo.time);
  exif.shorts(Tag::kPhoto, 0xa002, {static_cast<std::uint16_t>(photo.exif_width)});
  if (photo.focal_35mm) {
    exif.shorts(Tag::kPhoto, 0xa405, {static_cast<std::uint16_t>(*photo.focal_35mm)});
  }
  if (photo.latitude_deg) {
    exif.rationals(Tag::kGps, 2, {rational(*photo.latitude_deg)});
    exif.rationals(Tag::kGps, 4, {rational(photo.longitude_deg)});
  }
  if (photo.altitude_m) {
    exif.bytes(Tag::kGps, 5, {static_cast<std::uint8_t>(photo.altitude_ref)});
    exif.rationals(
        Tag::kGps, 6, {{static_cast<std::uint32_t>(std::llround(*photo.altitude_m * 100)), 100}});
  }
  return exif.build();
}

/// 12 photos over 60 x 40 m from 80 m above ground, 20 m apart.
[[nodiscard]] inline std::vector<PhotoSpec> healthy_flight() {
  std::vector<PhotoSpec> photos;
  for (int i = 0; i < 12; ++i) {
    PhotoSpec photo{.name = fmt::format("IMG_{:02}.JPG", i)};
    *photo.latitude_deg += 20.0 * (i / 4) * kDegPerMeter;
    const int column = (i / 4) % 2 == 0 ? i % 4 : 3 - i % 4;  // there and back
    photo.longitude_deg += 20.0 * column * kDegPerMeter / std::cos(0.84);
    photo.time = fmt::format("2026:05:01 10:00:{:02}", i);
    photo.texture = static_cast<std::uint64_t>(i);
    photos.push_back(photo);
  }
  return photos;
}

inline void write_photo(const std::filesystem::path& folder, const PhotoSpec& photo) {
  const Image8 image = photo.image.pixels.empty() ? textured_image(photo.texture) : photo.image;
  const std::filesystem::path path = folder / photo.name;
  ASSERT_TRUE(write_jpeg(path, image, 90));
  std::string jpeg = content_of(path);
  const auto insert = [&jpeg](const std::string& data) {
    jpeg.insert(2,
                "\xff\xe1" +
                    bytes_of(static_cast<std::uint16_t>(data.size() + 2), std::endian::big) + data);
  };
  std::string xmp;
  if (photo.relative_altitude_m) {
    xmp += fmt::format(R"( drone-dji:RelativeAltitude="{:.2f}")", *photo.relative_altitude_m);
  }
  if (photo.rtk) {
    xmp += R"( drone-dji:RtkFlag="50" drone-dji:RtkStdLon="0.02" drone-dji:RtkStdLat="0.02")"
           R"( drone-dji:RtkStdHgt="0.04")";
  }
  if (!xmp.empty()) insert(std::string("http://ns.adobe.com/xap/1.0/\0", 29) + "<x" + xmp + "/>");
  insert(std::string("Exif\0\0", 6) + exif_of(photo));
  std::ofstream(path, std::ios::binary) << jpeg;
}

/// A drive of 8 s: LiDAR 10 Hz, IMU 200 Hz, GNSS 5 Hz.
struct DriveSpec {
  bool lidar = true;
  bool imu = true;
  bool gnss = true;
  double imu_rate_hz = 200.0;
  double accel_z = 9.81;
  double gyro_x = 0.1;
  double imu_shift_s = 0.0;
  double speed_mps = 8.0;
  double latitude_deg = kSiteLatitude_deg;
  double unit_per_m = 1.0;
  int points = 300;
  bool point_time = true;
  std::vector<std::string> imu_frames = {"imu"};  ///< In turn.
  std::int8_t fix_status = 0;
  /// False: the message at this time [s] of this topic is left out.
  std::function<bool(const std::string& topic, double time_s)> keep = {};
  /// True: only half of the bytes of the message were recorded.
  std::function<bool(const std::string& topic, double time_s)> cut = {};
  /// Added to the stamp of a message [s].
  std::function<double(const std::string& topic, double time_s)> late = {};
};

[[nodiscard]] inline std::string scan_of(const DriveSpec& drive, std::int64_t stamp_ns) {
  std::vector<TestField> fields = {{"x", 7}, {"y", 7}, {"z", 7}, {"intensity", 7}};
  if (drive.point_time) fields.push_back({"time", 7});
  std::vector<std::vector<double>> values;
  for (int i = 0; i < drive.points; ++i) {
    const double azimuth = 6.28 * i / drive.points;
    values.push_back({10.0 * drive.unit_per_m * std::cos(azimuth),
                      10.0 * drive.unit_per_m * std::sin(azimuth),
                      drive.unit_per_m,
                      50.0});
    if (drive.point_time) values.back().push_back(0.1 * i / drive.points);
  }
  return cloud_message(stamp_ns, fields, values);
}

[[nodiscard]] inline std::string bag_of(const DriveSpec& drive) {
  constexpr double kDuration_s = 8.0;
  BagBuilder bag("lz4");
  const auto add_all = [&](const std::string& topic,
                           const std::string& type,
                           double rate_hz,
                           const std::function<std::string(std::int64_t, double)>& message) {
    const std::uint32_t connection = bag.add_topic(topic, type);
    for (int i = 0; i < static_cast<int>(kDuration_s * rate_hz); ++i) {
      const double time_s = i / rate_hz;
      if (drive.keep && !drive.keep(topic, time_s)) continue;
      const double late_s = drive.late ? drive.late(topic, time_s) : 0.0;
      constexpr std::int64_t kBegin_ns = 1'000'000'000'000'000'000;
      const std::int64_t recorded = kBegin_ns + std::llround(1e9 * time_s);
      std::string bytes = message(recorded + std::llround(1e9 * late_s), time_s);
      if (drive.cut && drive.cut(topic, time_s)) bytes.resize(bytes.size() / 2);
      bag.add_message(connection, recorded, bytes);
    }
    bag.end_chunk();
  };
  if (drive.lidar) {
    add_all("/points", "sensor_msgs/PointCloud2", 10.0, [&](std::int64_t stamp_ns, double) {
      return scan_of(drive, stamp_ns);
    });
  }
  if (drive.imu) {
    const auto shift_ns = static_cast<std::int64_t>(1e9 * drive.imu_shift_s);
    std::size_t sent = 0;
    add_all("/imu", "sensor_msgs/Imu", drive.imu_rate_hz, [&](std::int64_t stamp_ns, double) {
      const std::string& frame = drive.imu_frames[sent++ % drive.imu_frames.size()];
      return imu_message(stamp_ns + shift_ns, drive.gyro_x, drive.accel_z, frame);
    });
  }
  if (drive.gnss) {
    add_all("/fix", "sensor_msgs/NavSatFix", 5.0, [&](std::int64_t stamp_ns, double time_s) {
      const double latitude_deg = drive.latitude_deg + drive.speed_mps * time_s * kDegPerMeter;
      return fix_message(stamp_ns, latitude_deg, drive.fix_status, 2.0);
    });
  }
  return bag.finish();
}

inline constexpr const char* kGoodSensors =
    "lidar_topic: /points\nimu_topic: /imu\ngnss_topic: /fix\n"
    "imu_from_lidar: [1, 0, 0, 0.1, 0, 1, 0, 0, 0, 0, 1, 0.3, 0, 0, 0, 1]\n"
    "gnss_antenna_in_imu: [0, 0, 0.5]\n";

/// A flight and a drive of one site in a folder of their own; tests spoil parts of it.
class DoctorTest : public ::testing::Test {
 protected:
  void write_flight(const std::vector<PhotoSpec>& photos) const {
    std::filesystem::create_directories(images());
    for (const PhotoSpec& photo : photos) write_photo(images(), photo);
  }
  void write_drive(const DriveSpec& drive = {}, const std::string& sensors = kGoodSensors) const {
    (void)folder_.file("street.bag", bag_of(drive));
    if (!sensors.empty()) (void)folder_.file("sensors.yaml", sensors);
  }
  [[nodiscard]] std::filesystem::path images() const { return folder_.path() / "images"; }
  [[nodiscard]] std::filesystem::path bag() const { return folder_.path() / "street.bag"; }

  [[nodiscard]] DoctorReport report_of(const DoctorInputs& inputs) const {
    auto report = examine(inputs, options_, {});
    EXPECT_TRUE(report) << report.error().message;
    return report.value_or(DoctorReport{});
  }
  [[nodiscard]] static std::vector<std::string> ids_of(const DoctorReport& report) {
    std::vector<std::string> ids;
    for (const Finding& finding : report.findings) ids.push_back(finding.id);
    return ids;
  }
  /// The finding of that name, which is expected to be there.
  [[nodiscard]] static Finding finding(const DoctorReport& report, const std::string& id) {
    const auto found = std::ranges::find(report.findings, id, &Finding::id);
    EXPECT_NE(found, report.findings.end()) << id;
    return found == report.findings.end() ? Finding{} : *found;
  }

  TempFolder folder_ = {};
  PipelineOptions options_ = {};
};

}  // namespace hybridfusion::testing

#include "exif.hpp"
#include "jpeg_segments.hpp"
#include "text.hpp"
#include "xmp.hpp"

#include <hybridfusion/io/photo_metadata.hpp>

#include <chrono>
#include <cmath>

namespace hybridfusion {
namespace {

// Tags of Exif 2.32 (CIPA DC-008).
constexpr std::uint16_t kMake = 0x010f;
constexpr std::uint16_t kModel = 0x0110;
constexpr std::uint16_t kDateTime = 0x0132;
constexpr std::uint16_t kDateTimeOriginal = 0x9003;
constexpr std::uint16_t kOffsetTimeOriginal = 0x9011;
constexpr std::uint16_t kSubSecTimeOriginal = 0x9291;
constexpr std::uint16_t kFocalLength = 0x920a;
constexpr std::uint16_t kPixelXDimension = 0xa002;
constexpr std::uint16_t kFocalPlaneXResolution = 0xa20e;
constexpr std::uint16_t kFocalPlaneResolutionUnit = 0xa210;
constexpr std::uint16_t kFocalLengthIn35mmFilm = 0xa405;
constexpr std::uint16_t kBodySerialNumber = 0xa431;
constexpr std::uint16_t kGpsLatitudeRef = 1;
constexpr std::uint16_t kGpsLatitude = 2;
constexpr std::uint16_t kGpsLongitudeRef = 3;
constexpr std::uint16_t kGpsLongitude = 4;
constexpr std::uint16_t kGpsAltitudeRef = 5;
constexpr std::uint16_t kGpsAltitude = 6;
constexpr std::uint16_t kGpsDop = 11;
constexpr std::uint16_t kGpsHPositioningError = 31;

using enum ExifDirectory;

[[nodiscard]] std::optional<double> within(std::optional<double> value, double low, double high) {
  return value && *value >= low && *value <= high ? value : std::nullopt;  // nothing for NaN
}

[[nodiscard]] std::optional<double> positive(std::optional<double> value) {
  return value && *value > 0.0 && std::isfinite(*value) ? value : std::nullopt;
}

[[nodiscard]] std::optional<double> degrees(const Exif& exif,
                                            std::uint16_t tag,
                                            std::uint16_t ref_tag,
                                            char negative) {
  const auto whole = exif.number(kGps, tag, 0);
  if (!whole) return std::nullopt;
  const double minutes = exif.number(kGps, tag, 1).value_or(0.0);
  const double seconds = exif.number(kGps, tag, 2).value_or(0.0);
  const double angle = *whole + minutes / 60.0 + seconds / 3600.0;
  const std::string ref = lower_case(exif.text(kGps, ref_tag));
  return ref.starts_with(negative) ? -angle : angle;
}

[[nodiscard]] std::optional<double> altitude(const Exif& exif) {
  const auto value = exif.number(kGps, kGpsAltitude);
  if (!value) return std::nullopt;
  // 1: below sea level; 3 (Exif 3.0): below the ellipsoid. Some writers use the digit's character.
  const double ref = exif.number(kGps, kGpsAltitudeRef).value_or(0.0);
  const bool below = ref == 1.0 || ref == 3.0 || ref == '1';
  return within(below ? -*value : *value, -1e4, 1e5);
}

/// "2026:05:01 21:00:24", "198", "+02:00" (the last two may be empty; without a zone: UTC).
[[nodiscard]] std::optional<Timestamp> parse_time(std::string_view date_time,
                                                  std::string_view sub_seconds,
                                                  std::string_view zone) {
  using namespace std::chrono;
  if (date_time.size() < 19) return std::nullopt;
  const auto part = [date_time](std::size_t at, std::size_t length) {
    return parse_number<int>(date_time.substr(at, length)).value_or(-1);
  };
  const year_month_day date{year(part(0, 4)),
                            month(static_cast<unsigned>(part(5, 2))),
                            day(static_cast<unsigned>(part(8, 2)))};
  const int hour = part(11, 2);
  const int minute = part(14, 2);
  const int second = part(17, 2);
  const bool is_time =
      hour >= 0 && hour < 24 && minute >= 0 && minute < 60 && second >= 0 && second <= 60;
  if (!date.ok() || date.year() < year(1980) || date.year() > year(2200) || !is_time) {
    return std::nullopt;
  }
  Timestamp time =
      sys_days(date).time_since_epoch() + hours(hour) + minutes(minute) + seconds(second);
  if (const auto digits = parse_number<std::uint32_t>(sub_seconds.substr(0, 9))) {
    const double fraction =
        *digits / std::pow(10.0, static_cast<double>(std::min<std::size_t>(sub_seconds.size(), 9)));
    time += from_seconds(fraction);
  }
  if (zone.size() >= 6 && (zone[0] == '+' || zone[0] == '-')) {
    const auto zone_hours = parse_number<int>(zone.substr(1, 2));
    const auto zone_minutes = parse_number<int>(zone.substr(4, 2));
    if (zone_hours && zone_minutes && *zone_hours <= 14 && *zone_minutes < 60) {
      const auto shift = hours(*zone_hours) + minutes(*zone_minutes);
      time += zone[0] == '+' ? -shift : shift;
    }
  }
  return time;
}

[[nodiscard]] std::optional<double> focal_plane_px_per_mm(const Exif& exif) {
  const auto resolution = positive(exif.number(kPhoto, kFocalPlaneXResolution));
  if (!resolution) return std::nullopt;
  const double unit = exif.number(kPhoto, kFocalPlaneResolutionUnit).value_or(2.0);
  if (!(unit >= 0.0 && unit < 6.0)) return std::nullopt;
  switch (static_cast<int>(unit)) {
    case 2:
      return *resolution / 25.4;  // inch
    case 3:
      return *resolution / 10.0;  // cm
    case 4:
      return *resolution;  // mm
    case 5:
      return *resolution * 1000.0;  // um
    default:
      return std::nullopt;
  }
}

void read_exif(const Exif& exif, PhotoMetadata& photo) {
  photo.make = exif.text(kImage, kMake);
  photo.model = exif.text(kImage, kModel);
  photo.serial = exif.text(kPhoto, kBodySerialNumber);
  photo.focal_mm = positive(exif.number(kPhoto, kFocalLength));
  photo.focal_35mm = positive(exif.number(kPhoto, kFocalLengthIn35mmFilm));
  photo.focal_plane_px_per_mm = focal_plane_px_per_mm(exif);
  if (const auto width = within(exif.number(kPhoto, kPixelXDimension), 1.0, 1e6)) {
    photo.original_width = static_cast<int>(*width);
  }
  photo.time = parse_time(exif.text(kPhoto, kDateTimeOriginal),
                          exif.text(kPhoto, kSubSecTimeOriginal),
                          exif.text(kPhoto, kOffsetTimeOriginal));
  if (!photo.time) photo.time = parse_time(exif.text(kImage, kDateTime), "", "");
  photo.latitude_deg = within(degrees(exif, kGpsLatitude, kGpsLatitudeRef, 's'), -90.0, 90.0);
  photo.longitude_deg = within(degrees(exif, kGpsLongitude, kGpsLongitudeRef, 'w'), -180.0, 180.0);
  photo.altitude_m = altitude(exif);
  photo.gps_dop = positive(exif.number(kGps, kGpsDop));
  photo.gps_horizontal_error_m = positive(exif.number(kGps, kGpsHPositioningError));
}

void drop_impossible_position(std::optional<double>& latitude, std::optional<double>& longitude) {
  const bool null_island = latitude && longitude && *latitude == 0.0 && *longitude == 0.0;
  if (!latitude || !longitude || null_island) latitude = longitude = std::nullopt;
}

/// The XMP position has more digits where it repeats that of the EXIF, and is the better one where
/// the firmware cut the EXIF to whole minutes. Where they differ otherwise, the EXIF was corrected
/// later (PPK tools) and what the XMP says of the position is out of date.
void merge_position(const Xmp& xmp, PhotoMetadata& photo) {
  auto latitude = within(xmp.number("drone-dji:GpsLatitude"), -90.0, 90.0);
  auto longitude = within(xmp.number("drone-dji:GpsLongitude"), -180.0, 180.0);
  if (!longitude) longitude = within(xmp.number("drone-dji:GpsLongtitude"), -180.0, 180.0);
  drop_impossible_position(latitude, longitude);
  if (!latitude) return;
  constexpr double kSameDeg = 1e-5;  // 1.1 m
  const auto whole_minutes = [](double angle_deg) {
    const double minutes = angle_deg * 60.0;
    return std::abs(minutes - std::round(minutes)) < 1e-6;
  };
  const bool exif_is_cut = photo.latitude_deg && whole_minutes(*photo.latitude_deg) &&
                           whole_minutes(*photo.longitude_deg);
  const bool same = photo.latitude_deg && std::abs(*photo.latitude_deg - *latitude) < kSameDeg &&
                    std::abs(*photo.longitude_deg - *longitude) < kSameDeg;
  if (photo.latitude_deg && !same && !exif_is_cut) {
    photo.rtk_sigma_enu_m.reset();
    photo.absolute_altitude_m.reset();
    return;
  }
  photo.latitude_deg = latitude;
  photo.longitude_deg = longitude;
}

/// Focal length [px] of the factory calibration, for the size at hand.
[[nodiscard]] std::optional<double> calibrated_focal(const Xmp& xmp, int width_px) {
  // "date;fx,fy,cx,cy,k1,k2,p1,p2,k3"
  const std::string_view dewarp = xmp.text("drone-dji:DewarpData");
  const std::size_t semicolon = dewarp.find(';');
  std::optional<double> focal;
  if (semicolon != std::string_view::npos) {
    const std::string_view numbers = dewarp.substr(semicolon + 1);
    focal = parse_number<double>(trimmed(numbers.substr(0, numbers.find(','))));
  }
  if (!positive(focal)) focal = xmp.number("drone-dji:CalibratedFocalLength");
  // A reduced copy keeps the calibration of the original; its centre tells the original width.
  const auto center = positive(xmp.number("drone-dji:CalibratedOpticalCenterX"));
  const double ratio = center ? width_px / (2.0 * *center) : 1.0;
  const bool resized = ratio < 0.8 || ratio > 1.25;
  if (focal && resized) *focal *= ratio;
  return within(focal, 0.2 * width_px, 20.0 * width_px);
}

void read_xmp(const Xmp& xmp, PhotoMetadata& photo) {
  photo.absolute_altitude_m = within(xmp.number("drone-dji:AbsoluteAltitude"), -1e4, 1e5);
  photo.relative_altitude_m = within(xmp.number("drone-dji:RelativeAltitude"), -1e4, 1e5);
  const auto yaw = within(xmp.number("drone-dji:GimbalYawDegree"), -360.0, 360.0);
  const auto pitch = within(xmp.number("drone-dji:GimbalPitchDegree"), -360.0, 360.0);
  const auto roll = within(xmp.number("drone-dji:GimbalRollDegree"), -360.0, 360.0);
  if (yaw && pitch && roll)
    photo.gimbal = {.yaw_deg = *yaw, .pitch_deg = *pitch, .roll_deg = *roll};
  const auto east = positive(xmp.number("drone-dji:RtkStdLon"));
  const auto north = positive(xmp.number("drone-dji:RtkStdLat"));
  const auto up = positive(xmp.number("drone-dji:RtkStdHgt"));
  const bool rtk_was_on = xmp.number("drone-dji:RtkFlag").value_or(0.0) > 0.0;
  if (rtk_was_on && east && north && up)
    photo.rtk_sigma_enu_m = Eigen::Vector3d(*east, *north, *up);
  photo.calibrated_focal_px = calibrated_focal(xmp, photo.width);
  if (photo.serial.empty()) photo.serial = xmp.text("drone-dji:CameraSerialNumber");
  if (photo.serial.empty()) photo.serial = xmp.text("drone-dji:DroneSerialNumber");
  merge_position(xmp, photo);
}

}  // namespace

Expected<PhotoMetadata> read_photo_metadata(const std::filesystem::path& path) {
  HF_TRY(const JpegSegments segments, read_jpeg_segments(path));
  PhotoMetadata photo = {
      .name = path.filename().string(), .width = segments.width, .height = segments.height};
  read_exif(Exif(segments.exif), photo);
  drop_impossible_position(photo.latitude_deg, photo.longitude_deg);
  read_xmp(Xmp(segments.xmp), photo);
  return photo;
}

bool has_null_position(const std::filesystem::path& photo) {
  const auto segments = read_jpeg_segments(photo);
  if (!segments) return false;
  const Exif exif(segments->exif);
  return degrees(exif, kGpsLatitude, kGpsLatitudeRef, 's') == 0.0 &&
         degrees(exif, kGpsLongitude, kGpsLongitudeRef, 'w') == 0.0;
}

}  // namespace hybridfusion

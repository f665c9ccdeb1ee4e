#include "las_crs.hpp"

#include "byte_reader.hpp"
#include "crs.hpp"
#include "crs_units.hpp"
#include "text.hpp"

#include <cmath>
#include <map>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

/// Keys of GeoTIFF 1.0 (section 6.2) that matter here.
enum GeoKey : std::uint16_t {
  kModelType = 1024,
  kGeographic = 2048,
  kProjected = 3072,
  kLinearUnits = 3076,
  kLinearUnitSize = 3077,
  kVertical = 4096,
  kVerticalUnits = 4099,
};
constexpr int kUserDefined = 32767;

struct GeoKeys {
  std::map<int, int> values = {};
  std::map<int, double> doubles = {};
  std::string citation = {};

  [[nodiscard]] int code(GeoKey key) const {
    const auto found = values.find(key);
    return found == values.end() || found->second == kUserDefined ? 0 : found->second;
  }
  [[nodiscard]] bool is_user_defined(GeoKey key) const {
    const auto found = values.find(key);
    return found != values.end() && found->second == kUserDefined;
  }
};

/// Section 2.4: four numbers for each key.
[[nodiscard]] GeoKeys read_keys(const LasCrsRecords& records) {
  constexpr std::uint16_t kDoubleTag = 34736;
  constexpr std::uint16_t kAsciiTag = 34737;
  GeoKeys keys;
  ByteReader reader(records.geo_keys);
  reader.skip(3 * sizeof(std::uint16_t));
  const auto count = reader.read<std::uint16_t>();
  for (std::uint16_t i = 0; i < count && !reader.failed(); ++i) {
    const auto key = reader.read<std::uint16_t>();
    const auto place = reader.read<std::uint16_t>();
    const auto length = reader.read<std::uint16_t>();
    const auto value = reader.read<std::uint16_t>();
    if (place == 0) keys.values[key] = value;
    if (place == kDoubleTag && (value + 1U) * sizeof(double) <= records.geo_doubles.size()) {
      keys.doubles[key] = load<double>(records.geo_doubles.data() + value * sizeof(double));
    }
    if (place == kAsciiTag && keys.citation.empty() && value < records.geo_ascii.size()) {
      keys.citation = printable(records.geo_ascii.substr(value, length));
      while (keys.citation.ends_with('|')) keys.citation.pop_back();
    }
  }
  return keys;
}

[[nodiscard]] bool same_unit(double a, double b) {
  return std::abs(a / b - 1.0) < 1e-8;  // the feet differ by 2e-6
}

std::unexpected<Error> degrees(const InputFile& file, const std::string& name) {
  return file.malformed(fmt::format("its coordinates are degrees ({}), not metres", name),
                        "project them first, for example to UTM (pdal, las2las)");
}

/// The metres of a key of units; nothing when it is absent.
Expected<std::optional<double>> unit_of_key(const InputFile& file,
                                            const GeoKeys& keys,
                                            GeoKey key) {
  const auto found = keys.values.find(key);
  if (found == keys.values.end() || found->second == 0) return std::optional<double>{};
  if (found->second == kUserDefined) {
    const auto size = keys.doubles.find(kLinearUnitSize);
    if (key == kLinearUnits && size != keys.doubles.end() && size->second > 0.0) {
      return std::optional<double>(size->second);
    }
    return std::optional<double>{};
  }
  if (const auto metres = metres_of_unit_code(found->second)) return metres;
  return file.malformed(fmt::format("GeoTIFF key {} names the unit {}, which is not known",
                                    static_cast<int>(key),
                                    found->second),
                        "write the coordinates in metres");
}

/// Horizontal system and unit of the keys.
Expected<void> take_horizontal(const InputFile& file, const GeoKeys& keys, LasCrs& out) {
  out.crs.name = keys.citation;
  const int code = keys.code(kProjected);
  HF_TRY(const auto unit, unit_of_key(file, keys, kLinearUnits));
  double metres = unit.value_or(1.0);
  if (code == 0) {
    if (keys.is_user_defined(kProjected)) {
      out.warnings.push_back(
          fmt::format("its coordinate system ({}) is defined by keys of its own and is left out",
                      keys.citation.empty() ? "without a name" : keys.citation));
    }
  } else if (const auto known = describe_crs(code)) {
    out.crs = *known;
    const double own = known->metres_per_unit;
    if (unit && !same_unit(*unit, own) && own != 1.0) {
      return file.malformed(
          fmt::format("EPSG:{} counts in units of {}, but its key of linear units says {}",
                      code,
                      unit_name(own),
                      unit_name(*unit)),
          "correct the coordinate system of the file");
    }
    // Files in feet often carry the code of the metric system and say so only here.
    metres = unit.value_or(own);
  } else {
    out.warnings.push_back(fmt::format("EPSG:{} is not known to PROJ and is left out", code));
  }
  out.to_metres = Eigen::Vector3d::Constant(metres);
  return {};
}

Expected<void> take_vertical(const InputFile& file, const GeoKeys& keys, LasCrs& out) {
  HF_TRY(auto unit, unit_of_key(file, keys, kVerticalUnits));
  const int code = keys.code(kVertical);
  std::optional<AxisUnits> own;
  if (code != 0) own = axis_units(fmt::format("EPSG:{}", code));
  if (own && own->vertical_m && !unit) unit = own->vertical_m;
  if (own && own->depths) {
    return file.malformed(fmt::format("its heights are depths (EPSG:{})", code),
                          "turn them into heights first");
  }
  if (unit) {
    out.to_metres.z() = *unit;
  } else if (!same_unit(out.to_metres.x(), 1.0)) {
    out.warnings.push_back(fmt::format(
        "nothing says the unit of its heights; that of the horizontal coordinates ({}) is taken",
        unit_name(out.to_metres.x())));
  }
  const bool keeps_unit = own && own->vertical_m && same_unit(*own->vertical_m, out.to_metres.z());
  if (!out.crs.wkt.empty() && keeps_unit) {
    const std::string both = compound_wkt(out.crs.wkt, fmt::format("EPSG:{}", code));
    if (!both.empty()) out.crs = describe_crs(both);
  }
  return {};
}

Expected<LasCrs> crs_of_keys(const InputFile& file, const LasCrsRecords& records) {
  constexpr int kModelGeographic = 2;
  constexpr int kModelGeocentric = 3;
  const GeoKeys keys = read_keys(records);
  const int model = keys.code(kModelType);
  const bool projected = keys.values.contains(kProjected);
  LasCrs out;
  if (model == kModelGeocentric) {
    out.warnings.emplace_back("its coordinates are geocentric: z is not up");
    out.crs.name = keys.citation;
    return out;
  }
  const bool has_geographic = keys.code(kGeographic) != 0 || keys.is_user_defined(kGeographic);
  if (model == kModelGeographic || (model == 0 && !projected && has_geographic)) {
    const auto known = describe_crs(keys.code(kGeographic));
    return degrees(file, known ? known->name : keys.citation);
  }
  if (auto taken = take_horizontal(file, keys, out); !taken) return std::unexpected(taken.error());
  if (auto taken = take_vertical(file, keys, out); !taken) return std::unexpected(taken.error());
  return out;
}

Expected<LasCrs> crs_of_wkt(const InputFile& file, const std::string& text) {
  const auto [horizontal, vertical] = split_systems(text);
  const auto flat = axis_units(horizontal);
  if (!flat) {
    const std::string lower = lower_case(text);
    if (lower.find("foot") != std::string::npos || lower.find("feet") != std::string::npos) {
      return file.malformed("its coordinate system names feet but cannot be understood",
                            "correct the coordinate system of the file");
    }
    return LasCrs{.crs = describe_crs(text),
                  .warnings = {"its coordinate system cannot be understood; metres are assumed"}};
  }
  LasCrs out{.crs = describe_crs(horizontal)};
  if (flat->geographic) return degrees(file, out.crs.name);
  if (flat->geocentric) out.warnings.emplace_back("its coordinates are geocentric: z is not up");
  const auto high = vertical.empty() ? flat : axis_units(vertical);
  if (!vertical.empty() && (!high || !high->vertical_m)) {
    return file.malformed("the system of its heights cannot be understood",
                          "correct the coordinate system of the file");
  }
  if (high->depths) {
    return file.malformed("its heights are depths (an axis down)", "turn them into heights first");
  }
  if (!vertical.empty()) {
    const std::string both = compound_wkt(horizontal, vertical);
    if (both.empty()) {
      out.warnings.emplace_back("the system of its heights is left out");
    } else {
      out.crs = describe_crs(both);
    }
  }
  const double flat_m = flat->horizontal_m;
  out.to_metres = {flat_m, flat_m, high->vertical_m.value_or(flat_m)};
  if (!high->vertical_m && !flat->geocentric && !same_unit(flat_m, 1.0)) {
    out.warnings.push_back(fmt::format(
        "nothing says the unit of its heights; that of the horizontal coordinates ({}) is taken",
        unit_name(flat_m)));
  }
  return out;
}

}  // namespace

Expected<LasCrs> las_crs(const InputFile& file, const LasCrsRecords& records) {
  if (records.wkt.empty() && records.geo_keys.empty()) return LasCrs{};
  if (records.wkt.empty()) return crs_of_keys(file, records);
  HF_TRY(LasCrs out, crs_of_wkt(file, records.wkt));
  if (records.geo_keys.empty()) return out;
  // Both describe one system. Where they differ, the bit of the header decides.
  const auto keys = crs_of_keys(file, records);
  if (!keys || same_unit(keys->to_metres.x(), out.to_metres.x())) return out;
  if (!records.wkt_rules) out = *keys;
  out.warnings.push_back(
      fmt::format("its WKT and its GeoTIFF keys name different units; {} is taken",
                  unit_name(out.to_metres.x())));
  return out;
}

}  // namespace hybridfusion

#include "crs_accuracy.hpp"

#include <algorithm>
#include <memory>
#include <optional>
#include <vector>

#include <fmt/format.h>
#include <proj.h>

namespace hybridfusion {
namespace {

struct DestroyContext {
  void operator()(PJ_CONTEXT* context) const { proj_context_destroy(context); }
};
struct DestroyObject {
  void operator()(PJ* object) const { proj_destroy(object); }
};
struct DestroyFactory {
  void operator()(PJ_OPERATION_FACTORY_CONTEXT* factory) const {
    proj_operation_factory_context_destroy(factory);
  }
};
struct DestroyList {
  void operator()(PJ_OBJ_LIST* list) const { proj_list_destroy(list); }
};

/// A way from WGS84 to the system.
struct Operation {
  double accuracy_m = -1.0;               ///< Negative: unknown.
  std::vector<std::string> missing = {};  ///< Grids that are not installed.
  bool ballpark = false;
};

[[nodiscard]] std::vector<std::string> missing_of(PJ_CONTEXT* context, const PJ* operation) {
  std::vector<std::string> missing;
  const int count = proj_coordoperation_get_grid_used_count(context, operation);
  for (int i = 0; i < count; ++i) {
    const char* name = nullptr;
    int available = 0;
    if (proj_coordoperation_get_grid_used(context,
                                          operation,
                                          i,
                                          &name,
                                          nullptr,
                                          nullptr,
                                          nullptr,
                                          nullptr,
                                          nullptr,
                                          &available) != 0 &&
        available == 0 && name != nullptr) {
      missing.emplace_back(name);
    }
  }
  return missing;
}

/// All ways that hold at the place, as PROJ ranks them when every grid is there.
[[nodiscard]] std::vector<Operation> operations_at(const GeodeticOrigin& origin,
                                                   const std::string& crs) {
  constexpr double kReach_deg = 0.01;
  const std::unique_ptr<PJ_CONTEXT, DestroyContext> context(proj_context_create());
  proj_log_level(context.get(), PJ_LOG_NONE);
  const bool with_heights = crs.find('+') != std::string::npos;
  using Object = std::unique_ptr<PJ, DestroyObject>;
  const Object source(proj_create(context.get(), with_heights ? "EPSG:4979" : "EPSG:4326"));
  const Object target(proj_create(context.get(), crs.c_str()));
  const std::unique_ptr<PJ_OPERATION_FACTORY_CONTEXT, DestroyFactory> factory(
      proj_create_operation_factory_context(context.get(), nullptr));
  if (!source || !target || !factory) return {};
  proj_operation_factory_context_set_area_of_interest(context.get(),
                                                      factory.get(),
                                                      origin.longitude_deg - kReach_deg,
                                                      origin.latitude_deg - kReach_deg,
                                                      origin.longitude_deg + kReach_deg,
                                                      origin.latitude_deg + kReach_deg);
  proj_operation_factory_context_set_grid_availability_use(
      context.get(), factory.get(), PROJ_GRID_AVAILABILITY_IGNORED);
  const std::unique_ptr<PJ_OBJ_LIST, DestroyList> list(
      proj_create_operations(context.get(), source.get(), target.get(), factory.get()));
  std::vector<Operation> operations;
  for (int i = 0; list && i < proj_list_get_count(list.get()); ++i) {
    const Object operation(proj_list_get(context.get(), list.get(), i));
    operations.push_back(
        {.accuracy_m = proj_coordoperation_get_accuracy(context.get(), operation.get()),
         .missing = missing_of(context.get(), operation.get()),
         .ballpark =
             proj_coordoperation_has_ballpark_transformation(context.get(), operation.get()) != 0});
  }
  return operations;
}

/// The best of those that need a grid which is not there.
[[nodiscard]] const Operation* best_without_grid(const std::vector<Operation>& operations) {
  const Operation* best = nullptr;
  for (const Operation& operation : operations) {
    if (operation.missing.empty() || operation.ballpark || operation.accuracy_m < 0.0) continue;
    if (best == nullptr || operation.accuracy_m < best->accuracy_m) best = &operation;
  }
  return best;
}

/// Where to take a grid from. PROJ 9.1 asks for the file of the authority where it does not know
/// its own yet; it reads any of its formats under that name.
[[nodiscard]] std::string source_of(const std::string& grid) {
  if (grid.ends_with(".tif")) return fmt::format("{} (projsync --file {})", grid, grid);
  if (grid == "GCG2016.txt") return grid + " (de_bkg_gcg2016.tif of PROJ-data, saved as that)";
  return grid + " (GeoTIFF, GTX or NTv2 of PROJ-data, saved as that)";
}

[[nodiscard]] std::string told(const Operation& operation) {
  std::string files;
  for (const std::string& grid : operation.missing) {
    files += fmt::format("{}{}", files.empty() ? "" : " and ", source_of(grid));
  }
  return fmt::format(": install {} where PROJ looks, /usr/share/proj", files);
}

}  // namespace

std::string missing_grids(const GeodeticOrigin& origin, const std::string& crs) {
  const std::vector<Operation> operations = operations_at(origin, crs);
  const Operation* const best = best_without_grid(operations);
  return best == nullptr ? "" : told(*best);
}

Expected<std::string> judge_accuracy(const GeodeticOrigin& origin,
                                     const std::string& crs,
                                     bool allow_ballpark) {
  constexpr double kGood_m = 1.0;       // WGS84 itself is an ensemble of frames that far apart
  constexpr double kPlainGnss_m = 5.0;  // what positions without corrections are good for
  const std::vector<Operation> operations = operations_at(origin, crs);
  const auto usable = std::ranges::find_if(
      operations, [](const Operation& o) { return o.missing.empty() && !o.ballpark; });
  if (usable == operations.end() || usable->accuracy_m <= kGood_m) return std::string();
  const Operation* const better = best_without_grid(operations);
  std::string text = fmt::format("{}: positions are good to {:g} m only", crs, usable->accuracy_m);
  if (better != nullptr && better->accuracy_m < usable->accuracy_m) {
    text +=
        fmt::format(", with a grid that is missing to {:g} m{}", better->accuracy_m, told(*better));
  }
  if (usable->accuracy_m <= kPlainGnss_m || allow_ballpark) return text;
  return fail(ErrorCode::kInvalidOptions,
              text + "; take another system or accept it with --allow-ballpark");
}

}  // namespace hybridfusion

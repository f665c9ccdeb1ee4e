#include <hybridfusion/simulation/simulation_options.hpp>

namespace hybridfusion {

Expected<SimulationOptions> simulation_preset(std::string_view name) {
  SimulationOptions options;
  if (name == "small") {
    options.world.size_m = 60.0;
    options.camera.width_px = 1200;
    options.camera.height_px = 900;
    options.flight.oblique_photos = 12;
    options.drive.duration_s = 40.0;
    return options;
  }
  if (name == "paper") {
    options.world.main_building = 1;
    return options;
  }
  if (name == "city") {
    options.world.blocks_x = 5;
    options.world.blocks_y = 4;
    options.flight.oblique_photos = 8;
    options.drive.drives = 4;
    options.drive.duration_s = 180.0;
    options.samples_per_m2 = 2.0;
    return options;
  }
  return fail(ErrorCode::kInvalidOptions,
              "unknown preset '" + std::string(name) + "'; known are small, paper and city");
}

}  // namespace hybridfusion

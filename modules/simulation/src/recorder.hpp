#pragma once

#include "bag_writer.hpp"
#include "street_drive.hpp"

namespace hybridfusion {

inline constexpr double kFirstScan_s = 0.05;  ///< Since the start of the recording.

/// Everything that the sensors of one drive depend on.
struct RecorderInputs {
  const World& world;
  const RayTracer& tracer;
  const VehicleSetup& vehicle;
  const SimulationOptions& options;
  const GeodeticOrigin& origin;
  std::uint64_t index = 0;  ///< Number of the drive: its own noise.
};

/// Adds the topics to the bag and writes every message of the drive in the order of recording;
/// counts them in `record`. @returns kIo, kCancelled.
[[nodiscard]] Expected<void> record_messages(const RecorderInputs& inputs,
                                             DriveRecord& record,
                                             BagWriter& bag,
                                             const RunContext& ctx);

}  // namespace hybridfusion

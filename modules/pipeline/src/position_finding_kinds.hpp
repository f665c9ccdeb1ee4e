#pragma once

#include "finding_list.hpp"

#include <array>

namespace hybridfusion {

/// What can be wrong with the positions of photos and ground control against each other. An error
/// refuses the run as well.
inline constexpr std::array kPositionKinds = {
    FindingKind{"photos.altitude_ref",
                Severity::kWarning,
                "Some altitudes are below sea level although the rest says otherwise: the run does "
                "without them, or takes those of the XMP.",
                "Correct the tag, e.g. exiftool -GPSAltitudeRef=0 *.jpg"},
    FindingKind{"photos.weak_georeference",
                Severity::kWarning,
                "GNSS alone will leave scale or tilt open beyond 1 % or 1 degree: the report calls "
                "the georeference unusable.",
                "Give ground control or RTK positions, or run with a LiDAR recording, whose scale "
                "and level are taken."},
    FindingKind{"positions.unreadable",
                Severity::kError,
                "geo.txt or gcp_list.txt cannot be used.",
                "Correct the line that is named, or take the file away."},
    FindingKind{"positions.no_photos",
                Severity::kError,
                "None of the names in geo.txt is one of the photos.",
                "Give the names of the files, with folders where a name is there twice."},
    FindingKind{"positions.unknown_photos",
                Severity::kWarning,
                "Some names in geo.txt are none of the photos, or of several.",
                "Give the names of the files, with folders where a name is there twice."},
    FindingKind{"positions.contradict",
                Severity::kError,
                "geo.txt contradicts the photos' own positions.",
                "Correct the coordinate system in its first line or the order of its columns; if "
                "the photos are wrong, raise vision.max_conflict_sigma."},
    FindingKind{"positions.some_differ",
                Severity::kWarning,
                "Some positions in geo.txt contradict those of their photos; geo.txt is used.",
                "Check these rows: names may be exchanged."},
    FindingKind{"positions.height_unit",
                Severity::kError,
                "Heights in another unit than they are taken for.",
                "Give heights in the unit of the coordinate system, or name a system whose unit "
                "is theirs."},
    FindingKind{"positions.heights",
                Severity::kWarning,
                "Heights of two sources differ by more than their deviations.",
                "Give both above the ellipsoid; the result keeps those of ground control, then "
                "those of geo.txt."},
    FindingKind{"positions.extent",
                Severity::kError,
                "The photos lie within a millimetre or spread over 1000 km by their positions.",
                "Correct the coordinate system in the first line of geo.txt."},
    FindingKind{"positions.placement",
                Severity::kError,
                "Ground control or given poses lie elsewhere than the photos' own positions.",
                "Correct the coordinate system or the origin; if the photos are wrong, raise "
                "vision.max_conflict_sigma."},
    FindingKind{"control.far",
                Severity::kError,
                "Ground control lies farther from the photos than any of them can see.",
                "Correct the coordinate system in its first line or the row of the point."},
    FindingKind{"control.above",
                Severity::kWarning,
                "Ground control lies above the photos.",
                "Check unit and reference of the heights: feet, sea level or ellipsoid."},
    FindingKind{"control.unknown_photos",
                Severity::kWarning,
                "Marks of ground control name photos that are not there.",
                "Give the names of the files, with folders where a name is there twice."},
    FindingKind{"control.no_photos",
                Severity::kError,
                "No mark of ground control names one of the photos.",
                "Give the names of the files, with folders where a name is there twice."},
};

}  // namespace hybridfusion

#include "cloud_rows.hpp"
#include "ply_format.hpp"
#include "text.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/ply.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace hybridfusion {
namespace {

constexpr std::string_view kAgain = "export the cloud again";

/// Reads the elements before `name` away and returns it.
Expected<const PlyElement*> advance_to(PlyReader& reader, std::string_view name) {
  for (const PlyElement& element : reader.elements()) {
    if (element.name == name) return &element;
    if (auto skipped = reader.skip(element); !skipped) return std::unexpected(skipped.error());
  }
  return reader.file().malformed(fmt::format("there is no element '{}'", name),
                                 "give a file with points");
}

/// Calls `visit(row_index, scalars, lists)` for each row of `element`.
template <class Visit>
Expected<void> for_each_row(PlyReader& reader, const PlyElement& element, Visit&& visit) {
  if (element.properties.empty() && element.count > 0) {
    return reader.file().malformed(fmt::format("element '{}' has no properties", element.name),
                                   kAgain);
  }
  std::vector<double> scalars;
  std::vector<std::vector<double>> lists;
  for (std::uint64_t row = 0; row < element.count; ++row) {
    if (auto read = reader.read_row(element, scalars, lists); !read) return read;
    if (Expected<void> visited = visit(row, scalars, lists); !visited) return visited;
  }
  return {};
}

[[nodiscard]] std::vector<CloudColumn> columns_of(const PlyElement& element) {
  std::vector<CloudColumn> columns;
  for (const PlyProperty& property : element.properties) {
    // A list must not be taken for a coordinate: it keeps its place under a name nobody knows.
    columns.push_back(property.count_type ? CloudColumn{}
                                          : cloud_column(property.name, property.type));
  }
  return columns;
}

/// @param add  Takes a row; points that are not finite are its business.
template <class Add>
Expected<void> read_vertices(PlyReader& reader, const PlyElement& element, Add&& add) {
  if (!has_coordinates(columns_of(element))) {
    return reader.file().malformed("the vertices have no x, y and z", "give a file with points");
  }
  return for_each_row(
      reader,
      element,
      [&](std::uint64_t, const std::vector<double>& scalars, const auto&) -> Expected<void> {
        HF_TRY([[maybe_unused]] const bool kept, add(scalars));
        return {};
      });
}

/// The cloud of the next `element.count` vertices.
Expected<PointCloud> build_vertices(const std::filesystem::path& path,
                                    PlyReader& reader,
                                    const PlyElement& element) {
  CloudBuilder builder(columns_of(element));
  builder.reserve(element.count);
  auto read = read_vertices(reader, element, [&](std::span<const double> row) -> Expected<bool> {
    return builder.add(row);
  });
  if (!read) return std::unexpected(read.error());
  return finished(path, std::move(builder).finish());
}

[[nodiscard]] int property_index(const PlyElement& element,
                                 std::initializer_list<std::string_view> names,
                                 bool list) {
  for (std::size_t i = 0; i < element.properties.size(); ++i) {
    const PlyProperty& property = element.properties[i];
    if (property.count_type.has_value() == list &&
        std::ranges::find(names, property.name) != names.end()) {
      return static_cast<int>(i);
    }
  }
  return -1;
}

Expected<void> read_faces(PlyReader& reader, const PlyElement& element, TriangleMesh& mesh) {
  const int corners = property_index(element, {"vertex_indices", "vertex_index"}, true);
  const int label = property_index(element, {"label"}, false);
  if (corners < 0) {
    return reader.file().malformed("the faces have no list 'vertex_indices'",
                                   "export the mesh again");
  }
  const auto count = static_cast<double>(mesh.vertices.size());
  return for_each_row(
      reader,
      element,
      [&](std::uint64_t row, const auto& scalars, const auto& lists) -> Expected<void> {
        const std::vector<double>& polygon = lists[corners];
        if (!std::ranges::all_of(polygon, [count](double i) { return i >= 0.0 && i < count; })) {
          return reader.file().malformed(
              fmt::format("face {} names a vertex that does not exist", row),
              "export the mesh again");
        }
        for (std::size_t i = 2; i < polygon.size(); ++i) {
          mesh.triangles.push_back({static_cast<std::uint32_t>(polygon[0]),
                                    static_cast<std::uint32_t>(polygon[i - 1]),
                                    static_cast<std::uint32_t>(polygon[i])});
          if (label >= 0) {
            mesh.labels.push_back(
                static_cast<std::uint8_t>(std::clamp(scalars[label], 0.0, 255.0)));
          }
        }
        return {};
      });
}

}  // namespace

const std::vector<double>* PlyTable::find(std::string_view name) const {
  const auto found = std::ranges::find(names, name);
  return found == names.end() ? nullptr : &columns[found - names.begin()];
}

Expected<PointCloud> read_ply(const std::filesystem::path& path) {
  return build_cloud(path, read_ply_rows);
}

Expected<CloudFileFacts> read_ply_rows(const std::filesystem::path& path,
                                       const CloudRowSink& sink) {
  HF_TRY(PlyReader reader, PlyReader::open(path));
  HF_TRY(const PlyElement* vertices, advance_to(reader, "vertex"));
  sink.begin(reader.file(), columns_of(*vertices), vertices->count);
  if (auto read = read_vertices(reader, *vertices, sink.row); !read) {
    return std::unexpected(read.error());
  }
  CloudFileFacts facts;
  for (const PlyProperty& property : vertices->properties) {
    if (!property.count_type) continue;
    facts.warnings.push_back(
        fmt::format("list '{}' of its points is left out", printable(property.name)));
  }
  for (const PlyElement& element : reader.elements()) {
    if (element.name == vertices->name || element.count == 0) continue;
    facts.warnings.push_back(
        fmt::format("{} rows of '{}' are left out", element.count, printable(element.name)));
  }
  return facts;
}

Expected<void> read_ply_batches(const std::filesystem::path& path,
                                std::size_t batch_points,
                                const std::function<Expected<void>(PointCloud&&)>& visit) {
  HF_CHECK(batch_points > 0);
  HF_TRY(PlyReader reader, PlyReader::open(path));
  HF_TRY(const PlyElement* vertices, advance_to(reader, "vertex"));
  PlyElement batch = *vertices;
  for (std::uint64_t done = 0; done < vertices->count; done += batch.count) {
    batch.count = std::min<std::uint64_t>(batch_points, vertices->count - done);
    HF_TRY(PointCloud cloud, build_vertices(path, reader, batch));
    if (auto visited = visit(std::move(cloud)); !visited) return visited;
  }
  return {};
}

Expected<TriangleMesh> read_ply_mesh(const std::filesystem::path& path) {
  HF_TRY(PlyReader reader, PlyReader::open(path));
  TriangleMesh mesh;
  bool has_vertices = false;
  for (const PlyElement& element : reader.elements()) {
    if (element.name == "vertex" && !has_vertices) {
      HF_TRY(PointCloud cloud, build_vertices(path, reader, element));
      // The faces count the vertices.
      if (cloud.size() != element.count) {
        return reader.file().malformed("a vertex of the mesh is not finite", kAgain);
      }
      mesh.vertices = std::move(cloud.points);
      mesh.colors = std::move(cloud.colors);
      has_vertices = true;
    } else if (element.name == "face" && has_vertices) {
      if (auto read = read_faces(reader, element, mesh); !read)
        return std::unexpected(read.error());
      return mesh;
    } else if (auto skipped = reader.skip(element); !skipped) {
      return std::unexpected(skipped.error());
    }
  }
  return reader.file().malformed("there are no vertices followed by faces", "give a triangle mesh");
}

Expected<PlyTable> read_ply_columns(const std::filesystem::path& path) {
  HF_TRY(PlyReader reader, PlyReader::open(path));
  HF_TRY(const PlyElement* vertices, advance_to(reader, "vertex"));
  PlyTable table;
  std::vector<std::size_t> from;
  for (std::size_t i = 0; i < vertices->properties.size(); ++i) {
    if (vertices->properties[i].count_type) continue;
    from.push_back(i);
    table.names.push_back(vertices->properties[i].name);
  }
  table.columns.resize(from.size());
  for (std::vector<double>& column : table.columns) column.reserve(vertices->count);
  auto read = for_each_row(
      reader, *vertices, [&](std::uint64_t, const auto& scalars, const auto&) -> Expected<void> {
        for (std::size_t c = 0; c < from.size(); ++c) table.columns[c].push_back(scalars[from[c]]);
        return {};
      });
  if (!read) return std::unexpected(read.error());
  return table;
}

}  // namespace hybridfusion

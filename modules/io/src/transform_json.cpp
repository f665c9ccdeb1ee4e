#include "json_file.hpp"

#include <hybridfusion/io/atomic_file.hpp>
#include <hybridfusion/io/transform_json.hpp>

#include <fmt/format.h>

namespace hybridfusion {

Expected<Rigid3> read_transform_json(const std::filesystem::path& path, std::string_view key) {
  HF_TRY(const nlohmann::json root, read_json_object(path));
  return json_rigid(path, root, key);
}

Expected<void> write_transform_json(const std::filesystem::path& path,
                                    std::string_view key,
                                    const Rigid3& target_from_source) {
  const Eigen::Matrix<double, 4, 4, Eigen::RowMajor> matrix = target_from_source.matrix();
  nlohmann::json root;
  root[std::string(key)] = std::vector<double>(matrix.data(), matrix.data() + matrix.size());
  return write_file_atomically(path, root.dump() + "\n");
}

}  // namespace hybridfusion

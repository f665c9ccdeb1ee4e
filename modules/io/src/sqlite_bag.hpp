#pragma once

#include <hybridfusion/io/rosbag1.hpp>

namespace hybridfusion {

/// Streams the messages of a ROS 2 bag file of the sqlite3 storage (.db3) in the order of their
/// time. The database is opened read-only and nothing is written beside it.
class SqliteBag {
 public:
  /// @param name  What messages call the file; empty: its path.
  /// @returns kNotFound; kParse when it is no sound SQLite file with the tables of a bag.
  [[nodiscard]] static Expected<SqliteBag> open(const std::filesystem::path& path,
                                                const std::filesystem::path& name);

  SqliteBag(SqliteBag&&) noexcept;
  SqliteBag& operator=(SqliteBag&&) noexcept;
  ~SqliteBag();

  /// Topics of CDR messages; others are left out.
  [[nodiscard]] const std::vector<BagConnection>& connections() const;
  /// To be called before next().
  void select_topics(const std::vector<std::string>& topics);
  /// Nothing at the end, and where the database is damaged (truncated() says so).
  [[nodiscard]] Expected<std::optional<BagMessage>> next();

  [[nodiscard]] bool truncated() const;
  [[nodiscard]] const std::vector<std::string>& warnings() const;

 private:
  struct State;
  explicit SqliteBag(std::unique_ptr<State> state);
  std::unique_ptr<State> state_;
};

}  // namespace hybridfusion

#include "sqlite_bag.hpp"

#include "input_file.hpp"
#include "recorded_clock.hpp"
#include "text.hpp"

#include <algorithm>
#include <map>
#include <utility>

#include <fmt/format.h>
#include <sqlite3.h>

namespace hybridfusion {
namespace {

// Nobody records messages of more than 512 MiB; SQLite refuses longer values itself.
constexpr int kMaxValueBytes = 1 << 29;
constexpr int kMaxTopics = 65536;

using Database = std::unique_ptr<sqlite3, decltype(&sqlite3_close)>;
using Statement = std::unique_ptr<sqlite3_stmt, decltype(&sqlite3_finalize)>;

[[nodiscard]] Statement prepare(sqlite3* database, const std::string& sql) {
  sqlite3_stmt* statement = nullptr;
  sqlite3_prepare_v2(database, sql.c_str(), -1, &statement, nullptr);
  return {statement, &sqlite3_finalize};
}

/// A path as a file: URI, in which '?', '#' and '%' mean something.
[[nodiscard]] std::string as_uri(const std::filesystem::path& path, std::string_view parameters) {
  std::string uri = "file:";
  for (const char c : std::filesystem::absolute(path).string()) {
    const bool plain = c != '?' && c != '#' && c != '%';
    uri += plain ? std::string(1, c) : fmt::format("%{:02x}", static_cast<unsigned char>(c));
  }
  return uri + std::string(parameters);
}

[[nodiscard]] Database open_uri(const std::string& uri) {
  sqlite3* raw = nullptr;
  const int status =
      sqlite3_open_v2(uri.c_str(), &raw, SQLITE_OPEN_READONLY | SQLITE_OPEN_URI, nullptr);
  Database database(raw, &sqlite3_close);
  if (status != SQLITE_OK || raw == nullptr) return {nullptr, &sqlite3_close};
  sqlite3_limit(raw, SQLITE_LIMIT_LENGTH, kMaxValueBytes);
  // A file may define views and functions of its own; none of them may run.
  sqlite3_db_config(raw, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
  sqlite3_db_config(raw, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
  return database;
}

/// Messages that a killed recorder did not get to move into the database.
[[nodiscard]] bool has_log(const std::filesystem::path& path) {
  std::error_code code;
  const auto bytes = std::filesystem::file_size(path.string() + "-wal", code);
  return !code && bytes > 0;
}

/// Reading "<file>-wal" needs a helper file of SQLite's beside it; without one, and without a log,
/// the database is read as it lies.
[[nodiscard]] Database open_database(const std::filesystem::path& path) {
  if (has_log(path)) {
    Database database = open_uri(as_uri(path, "?mode=ro"));
    if (database && prepare(database.get(), "SELECT 1 FROM sqlite_master")) return database;
  }
  return open_uri(as_uri(path, "?mode=ro&immutable=1"));
}

[[nodiscard]] std::string text_of(sqlite3_stmt* statement, int column) {
  const auto* const text = sqlite3_column_text(statement, column);
  if (text == nullptr) return {};
  return {reinterpret_cast<const char*>(text),
          static_cast<std::size_t>(sqlite3_column_bytes(statement, column))};
}

}  // namespace

struct SqliteBag::State {
  State() = default;
  State(const State&) = delete;
  State& operator=(const State&) = delete;
  ~State();

  std::filesystem::path name = {};
  Database database{nullptr, &sqlite3_close};
  Statement query{nullptr, &sqlite3_finalize};
  std::vector<BagConnection> connections = {};
  std::optional<std::vector<std::string>> topics = {};
  bool truncated = false;
  std::vector<std::string> warnings = {};
  /// Times of recording do not give the order: one topic's messages are written as they come.
  bool clock_goes_back = false;
  RecordedClock clock = {};
  std::filesystem::path helper = {};  ///< SQLite's, if it was not there before.

  [[nodiscard]] std::unexpected<Error> malformed() const {
    return fail(ErrorCode::kParse,
                fmt::format("{}: not a sound ROS 2 bag (SQLite: {}); copy or record it again",
                            name.string(),
                            sqlite3_errmsg(database.get())));
  }
  [[nodiscard]] bool has(std::string_view kind, std::string_view column, std::string_view value) {
    const Statement found =
        prepare(database.get(),
                fmt::format("SELECT 1 FROM sqlite_master WHERE type = '{}' AND {} = '{}' AND "
                            "coalesce(sql, '') NOT LIKE 'CREATE VIRTUAL%'",
                            kind,
                            column,
                            value));
    return found && sqlite3_step(found.get()) == SQLITE_ROW;
  }
  [[nodiscard]] Expected<void> read_topics();
  void count_messages();
  [[nodiscard]] Expected<void> start_query();
};

SqliteBag::State::~State() {
  query.reset();
  database.reset();
  std::error_code ignored;
  if (!helper.empty()) std::filesystem::remove(helper, ignored);
}

Expected<void> SqliteBag::State::read_topics() {
  if (!has("table", "name", "topics") || !has("table", "name", "messages")) return malformed();
  const Statement topics_query =
      prepare(database.get(), "SELECT id, name, type, serialization_format FROM topics");
  if (!topics_query) return malformed();
  int status = SQLITE_ROW;
  for (int i = 0; i < kMaxTopics; ++i) {
    status = sqlite3_step(topics_query.get());
    if (status != SQLITE_ROW) break;
    const std::int64_t id = sqlite3_column_int64(topics_query.get(), 0);
    if (text_of(topics_query.get(), 3) != "cdr" || id < 0 || id > 0xffffffffLL) continue;
    connections.push_back({.id = static_cast<std::uint32_t>(id),
                           .topic = text_of(topics_query.get(), 1),
                           .type = text_of(topics_query.get(), 2),
                           .wire = RosWire::kCdr});
  }
  if (status != SQLITE_DONE && status != SQLITE_ROW) return malformed();
  count_messages();
  return {};
}

void SqliteBag::State::count_messages() {
  // Reads every row's head; a damaged database gives no counts.
  const Statement rows =
      prepare(database.get(), "SELECT topic_id, timestamp FROM messages ORDER BY id");
  struct Topic {
    std::uint64_t messages = 0;
    std::int64_t last = 0;
  };
  std::map<std::int64_t, Topic> by_topic;
  int status = SQLITE_ERROR;
  while (rows && (status = sqlite3_step(rows.get())) == SQLITE_ROW) {
    Topic& topic = by_topic[sqlite3_column_int64(rows.get(), 0)];
    const std::int64_t time = sqlite3_column_int64(rows.get(), 1);
    clock_goes_back = clock_goes_back || (topic.messages > 0 && time < topic.last);
    topic.last = time;
    ++topic.messages;
  }
  if (status != SQLITE_DONE) return;
  for (BagConnection& connection : connections) {
    connection.messages = by_topic[connection.id].messages;
  }
}

Expected<void> SqliteBag::State::start_query() {
  std::string ids;
  for (const BagConnection& connection : connections) {
    if (topics && std::ranges::find(*topics, connection.topic) == topics->end()) continue;
    ids += fmt::format("{}{}", ids.empty() ? "" : ", ", connection.id);
  }
  // Recorders make an index on the time. Without one, sorting would copy the whole recording; rows
  // are then taken in the order in which they were written.
  const bool by_time = has("index", "tbl_name", "messages") && !clock_goes_back;
  const char* const order = by_time ? "timestamp, id" : "id";
  query = prepare(database.get(),
                  fmt::format("SELECT topic_id, timestamp, data FROM messages WHERE topic_id IN "
                              "({}) ORDER BY {}",
                              ids,
                              order));
  if (!query) return malformed();
  return {};
}

SqliteBag::SqliteBag(std::unique_ptr<State> state) : state_(std::move(state)) {}
SqliteBag::SqliteBag(SqliteBag&&) noexcept = default;
SqliteBag& SqliteBag::operator=(SqliteBag&&) noexcept = default;
SqliteBag::~SqliteBag() = default;

Expected<SqliteBag> SqliteBag::open(const std::filesystem::path& path,
                                    const std::filesystem::path& name) {
  HF_TRY(const InputFile readable, InputFile::open(path, name));
  auto state = std::make_unique<State>();
  state->name = readable.path();
  const std::filesystem::path helper = path.string() + "-shm";
  std::error_code code;
  if (has_log(path) && !std::filesystem::exists(helper, code)) state->helper = helper;
  state->database = open_database(path);
  if (!state->database) {
    return readable.malformed("SQLite cannot open it", "copy or record it again");
  }
  if (auto read = state->read_topics(); !read) return std::unexpected(read.error());
  return SqliteBag(std::move(state));
}

const std::vector<BagConnection>& SqliteBag::connections() const {
  return state_->connections;
}

void SqliteBag::select_topics(const std::vector<std::string>& topics) {
  state_->topics = topics;
}

Expected<std::optional<BagMessage>> SqliteBag::next() {
  State& state = *state_;
  if (state.truncated) return std::nullopt;
  if (!state.query) {
    if (auto started = state.start_query(); !started) return std::unexpected(started.error());
  }
  const int status = sqlite3_step(state.query.get());
  if (status == SQLITE_DONE) return std::nullopt;
  if (status != SQLITE_ROW) {
    state.truncated = true;
    state.warnings.push_back(fmt::format("{}: the database is damaged ({}); what precedes is used",
                                         state.name.string(),
                                         sqlite3_errmsg(state.database.get())));
    return std::nullopt;
  }
  const auto* const blob = static_cast<const std::byte*>(sqlite3_column_blob(state.query.get(), 2));
  const auto size = static_cast<std::size_t>(sqlite3_column_bytes(state.query.get(), 2));
  auto storage = std::make_shared<const std::vector<std::byte>>(blob, blob + size);
  const auto topic = static_cast<std::uint32_t>(sqlite3_column_int64(state.query.get(), 0));
  return BagMessage{
      .connection = topic,
      .time = state.clock.place(topic, Timestamp(sqlite3_column_int64(state.query.get(), 1))),
      .data = *storage,
      .storage = storage};
}

bool SqliteBag::truncated() const {
  return state_->truncated;
}

const std::vector<std::string>& SqliteBag::warnings() const {
  return state_->warnings;
}

}  // namespace hybridfusion

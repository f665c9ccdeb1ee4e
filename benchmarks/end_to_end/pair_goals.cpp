#include "pair_table.hpp"
#include "quantile.hpp"

#include <algorithm>
#include <cmath>
#include <initializer_list>
#include <string_view>

#include <fmt/format.h>

namespace hybridfusion::benchmark {
namespace {

/// Answers of one method to the pairs of some kinds.
class Answers {
 public:
  Answers(const std::vector<Outcome>& outcomes,
          const std::string& method,
          std::initializer_list<PairKind> kinds) {
    for (const Outcome& o : outcomes) {
      const auto group = std::ranges::find(case_groups(), o.group, &CaseGroup::name);
      if (o.method != method || group == case_groups().end()) continue;
      if (kinds.size() > 0 && std::ranges::find(kinds, group->kind) == kinds.end()) continue;
      answers_.push_back(&o);
    }
  }

  [[nodiscard]] std::size_t size() const { return answers_.size(); }
  template <class Is>
  [[nodiscard]] std::size_t count(Is is) const {
    return static_cast<std::size_t>(
        std::ranges::count_if(answers_, [&](const Outcome* o) { return is(*o); }));
  }
  /// Of the right ones.
  template <class Get>
  [[nodiscard]] std::vector<double> values(Get get) const {
    std::vector<double> result;
    for (const Outcome* o : answers_) {
      if (o->ok && o->right) result.push_back(get(*o));
    }
    return result;
  }

 private:
  std::vector<const Outcome*> answers_ = {};
};

void row(std::string_view goal, std::size_t n, const std::string& reached, bool is_met) {
  fmt::print("| {} | {} | {} | {} |\n", goal, n, reached, n == 0 ? "-" : (is_met ? "yes" : "no"));
}

/// A row on quantiles of one error of the right answers; a limit of 0 is none.
template <class Get>
void error_row(std::string_view goal,
               const Answers& answers,
               double median_limit,
               double most_limit,
               Get get) {
  const std::vector<double> values = answers.values(get);
  const auto within = [&](double share, double limit) {
    return limit == 0.0 || (!values.empty() && quantile(values, share) <= limit);
  };
  row(goal,
      values.size(),
      fmt::format("{} / {}", figure(values, 0.5, 3), figure(values, 0.95, 3)),
      within(0.5, median_limit) && within(0.95, most_limit));
}

void share_row(std::string_view goal, const Answers& answers, double least) {
  const std::size_t right = answers.count([](const Outcome& o) { return o.ok && o.right; });
  const double share =
      static_cast<double>(right) / std::max(1.0, static_cast<double>(answers.size()));
  row(goal, answers.size(), fmt::format("{:.1f} %", 100.0 * share), share >= least);
}

/// CPU seconds as shares of those of a peer in the same run, pair by pair; no row without the peer.
void speed_row(const std::vector<Outcome>& outcomes,
               const std::string& method,
               std::string_view peer) {
  std::vector<double> shares;
  for (const Outcome& ours : outcomes) {
    if (ours.method != method || method == peer) continue;
    const auto theirs = std::ranges::find_if(outcomes, [&](const Outcome& o) {
      return o.method == peer && o.group == ours.group && o.seed == ours.seed;
    });
    if (theirs != outcomes.end() && theirs->cpu_s > 0.0) {
      shares.push_back(ours.cpu_s / theirs->cpu_s);
    }
  }
  if (shares.empty()) return;
  const double most = std::ranges::max(shares);
  row(fmt::format("CPU of {}'s on the same pair: at most 1 (median / most)", peer),
      shares.size(),
      fmt::format("{} / {:.2f}", figure(shares, 0.5, 2), most),
      most <= 1.0);
}

}  // namespace

void print_goals(const std::vector<Outcome>& outcomes, const std::string& method) {
  const auto error_m = [](const Outcome& o) { return o.errors.at_centroid_m; };
  const auto answers = [&](std::initializer_list<PairKind> kinds) {
    return Answers(outcomes, method, kinds);
  };
  const Answers all = answers({});
  const Answers clean = answers({PairKind::kClean, PairKind::kCrop});
  const Answers whole =
      answers({PairKind::kClean, PairKind::kThick, PairKind::kScaleDrift, PairKind::kBent});
  fmt::print(
      "\n### Goals, {}\n\n"
      "| goal | pairs | reached (of the right answers: median / 95 %) | met |\n"
      "|---|---|---|---|\n",
      method);
  share_row("right, LiDAR of the whole street: 99 %", whole, 0.99);
  share_row("right, LiDAR within 20 or 30 m: 95 %", answers({PairKind::kCrop}), 0.95);
  const std::size_t wrong = all.count([](const Outcome& o) { return o.ok && !o.right; });
  row("wrong poses given as right: 0", all.size(), fmt::format("{}", wrong), wrong == 0);
  error_row("error, clean: 0.02 m median, 0.15 m 95 %", clean, 0.02, 0.15, error_m);
  error_row("error, thick vision cloud: 0.06 m median, 0.15 m 95 %",
            answers({PairKind::kThick}),
            0.06,
            0.15,
            error_m);
  error_row("LiDAR points to their places, 0.2 % scale and drift: 0.10 m",
            answers({PairKind::kScaleDrift}),
            0.0,
            0.10,
            [](const Outcome& o) { return o.places_m; });
  error_row("scale error where the drive is bent: 0.1 %",
            answers({PairKind::kBent}),
            0.0,
            0.1,
            [](const Outcome& o) { return 100.0 * std::abs(o.scale_error); });
  error_row("heading, clean: 0.03 deg", clean, 0.0, 0.03, [](const Outcome& o) {
    return std::abs(o.yaw_deg);
  });
  error_row("height, clean: 0.02 m", clean, 0.0, 0.02, [](const Outcome& o) {
    return std::abs(o.errors.vertical_m);
  });
  error_row("CPU: 5 s", clean, 0.0, 5.0, [](const Outcome& o) { return o.cpu_s; });
  speed_row(outcomes, method, "gicp");
}

}  // namespace hybridfusion::benchmark

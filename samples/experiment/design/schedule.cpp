#include "samples/experiment/design/schedule.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <utility>

#include "samples/app/text/format.h"
#include "samples/experiment/design/draws.h"

namespace hrt::experiment {
namespace {

constexpr unsigned max_tries = 10'000;

// True if no catch trial is first or follows another catch trial, and no pair comes more than max_run times in a row.
// The second condition applies only with `has_pairs`.
bool is_legal(const std::vector<PlannedTrial>& trials, unsigned max_run, bool has_pairs) {
  unsigned run = 0;
  for (std::size_t i = 0; i < trials.size(); ++i) {
    if (trials[i].is_catch && (i == 0 || trials[i - 1].is_catch)) return false;
    run = i > 0 && trials[i].pair == trials[i - 1].pair ? run + 1 : 1;
    if (has_pairs && run > max_run) return false;
  }
  return true;
}

Block made(BlockKind kind, std::vector<PlannedTrial> trials, const Design& design, unsigned participant,
           unsigned number) {
  Stream stream(Use::trials, {.seed = design.seed, .participant = participant, .block = number});
  const bool has_pairs = design.pairs.size() > 1 && kind == BlockKind::reaches;
  unsigned tries = 0;
  do {
    if (++tries > max_tries)
      throw Refusal(
          format("max_run of the design: none of %u random orders of block %u has at most %u trials of a pair in a "
                 "row, and no catch trial first or after another one; increase max_run or reduce catch_share",
                 max_tries, number, design.max_run));
    stream.shuffle(trials);
  } while (!is_legal(trials, design.max_run, has_pairs));
  for (std::size_t i = 0; i < trials.size(); ++i) trials[i].number = static_cast<unsigned>(i) + 1;
  return {kind, std::move(trials)};
}

// Returns the trials of a block, not yet in random order. Catch trials are assigned to the conditions in turn, from
// index `first` on.
std::vector<PlannedTrial> trials_of(const Design& design, const std::vector<unsigned>& conditions, unsigned first) {
  std::vector<PlannedTrial> trials;
  for (const unsigned condition : conditions)
    for (unsigned pair = 0; pair < design.pairs.size(); ++pair)
      for (unsigned i = 0; i < design.repeats; ++i) trials.push_back({0, condition, pair, false});
  const auto catches = std::lround(design.catch_share * static_cast<double>(trials.size()));
  for (unsigned i = 0; i < catches; ++i)
    trials.push_back(
        {0, conditions[(first + i) % conditions.size()], i % static_cast<unsigned>(design.pairs.size()), true});
  return trials;
}

std::vector<unsigned> all_conditions(const Design& design) {
  std::vector<unsigned> all(design.conditions.size());
  for (unsigned i = 0; i < all.size(); ++i) all[i] = i;
  return all;
}

std::vector<unsigned> permuted(unsigned count, Use use, const Place& place) {
  std::vector<unsigned> values(count);
  std::iota(values.begin(), values.end(), 0U);
  Stream(use, place).shuffle(values);
  return values;
}

unsigned index_in_design(const Design& design, unsigned participant) { return (participant - 1) % design.participants; }

// Returns the index of a participant's level. With n levels, participants 1 to n have n different levels, in random
// order; likewise the next n participants, and so on.
unsigned level_for(const Design& design, unsigned participant) {
  const auto levels = std::max<unsigned>(1, static_cast<unsigned>(design.levels.size()));
  const unsigned index = index_in_design(design, participant);
  return permuted(levels, Use::orders, {.seed = design.seed, .block = index / levels, .trial = 1})[index % levels];
}

// Returns the order of conditions of a participant. The participants of a level get complete sets of orders, each set
// in random order.
std::vector<unsigned> order_for(const Design& design, unsigned participant) {
  if (design.order == Order::random_in_blocks) return {};
  const auto orders =
      design.order == Order::listed ? design.listed : williams_orders(static_cast<unsigned>(design.conditions.size()));
  const auto count = static_cast<unsigned>(orders.size());
  const auto levels = std::max<unsigned>(1, static_cast<unsigned>(design.levels.size()));
  const unsigned of_level = index_in_design(design, participant) / levels, level = level_for(design, participant);
  const Place place{.seed = design.seed, .participant = level, .block = of_level / count};
  return orders[permuted(count, Use::orders, place)[of_level % count]];
}

Block noticeability_block(const Design& design, unsigned participant, unsigned number) {
  std::vector<PlannedTrial> trials;
  for (unsigned i = 0; i < design.noticeability->trials; ++i)
    trials.push_back({0, design.noticeability->condition, i % design.noticeability->runs, false});
  const auto catches = std::lround(design.catch_share * static_cast<double>(trials.size()));
  trials.insert(trials.end(), static_cast<std::size_t>(catches),
                PlannedTrial{0, design.noticeability->condition, 0, true});
  return made(BlockKind::noticeability, std::move(trials), design, participant, number);
}

std::string letters_of(const Design& design, unsigned participant, const std::vector<unsigned>& order) {
  std::string text;
  for (const unsigned condition : order) text += (text.empty() ? "" : " ") + letter_of(design, participant, condition);
  return text;
}

std::string balance_text(const Design& design) {
  if (design.order == Order::random_in_blocks)
    return "balance: every block has every condition and pair equally often\n";
  if (design.conditions.size() == 1) return "balance: there is only one condition\n";
  std::map<std::pair<unsigned, unsigned>, unsigned> follows;
  for (unsigned p = 1; p <= design.participants; ++p) {
    const std::vector<unsigned> order = order_for(design, p);
    for (std::size_t i = 1; i < order.size(); ++i) ++follows[{order[i - 1], order[i]}];
  }
  unsigned low = follows.empty() ? 0 : follows.begin()->second, high = low;
  const std::size_t pairs = design.conditions.size() * (design.conditions.size() - 1);
  if (follows.size() < pairs) low = 0;
  for (const auto& [pair, count] : follows) {
    low = std::min(low, count);
    high = std::max(high, count);
  }
  return format("balance: each condition directly follows each other condition %u to %u times\n", low, high);
}

}  // namespace

std::vector<std::vector<unsigned>> williams_orders(unsigned count) {
  std::vector<unsigned> first;  // 0, 1, count - 1, 2, count - 2 ...
  for (unsigned i = 0; i < count; ++i) first.push_back(i % 2 == 1 ? (i + 1) / 2 : (count - i / 2) % count);
  std::vector<std::vector<unsigned>> orders;
  for (unsigned shift = 0; shift < count; ++shift) {
    std::vector<unsigned> order;
    for (const unsigned place : first) order.push_back((place + shift) % count);
    orders.push_back(order);
  }
  if (count % 2 == 1 && count > 1)
    for (unsigned i = 0; i < count; ++i) orders.emplace_back(orders[i].rbegin(), orders[i].rend());
  return orders;
}

Schedule schedule_of(const Design& design, unsigned participant) {
  Schedule schedule{};
  schedule.level = level_for(design, participant);
  schedule.order = order_for(design, participant);
  Block practice{BlockKind::practice, {}};
  for (unsigned i = 0; i < design.practice_trials; ++i)
    practice.trials.push_back({i + 1, 0, i % static_cast<unsigned>(design.pairs.size()), true});
  schedule.blocks.push_back(practice);
  for (unsigned round = 0; round < design.rounds; ++round) {
    std::vector<std::vector<unsigned>> sets;
    for (const unsigned condition : schedule.order) sets.push_back({condition});
    if (schedule.order.empty()) sets.push_back(all_conditions(design));
    for (const std::vector<unsigned>& set : sets)
      schedule.blocks.push_back(made(BlockKind::reaches, trials_of(design, set, participant + round), design,
                                     participant, static_cast<unsigned>(schedule.blocks.size())));
  }
  if (design.noticeability)
    schedule.blocks.push_back(noticeability_block(design, participant, static_cast<unsigned>(schedule.blocks.size())));
  return schedule;
}

std::string plan_text(const Design& design, const Schedule& schedule) {
  constexpr double consent_min = 5.0, calibration_min = 6.0, item_min = 0.15, min_per_s = 1.0 / 60.0;
  std::string text;
  double now_min = 0.0;
  const auto add = [&](const std::string& what, double minutes) {
    text += format("| %.0f | ", now_min) + what + " |\n";
    now_min += minutes;
  };
  const auto add_questionnaires = [&](const std::string& when) {
    for (const Questionnaire& paper : design.questionnaires)
      if (paper.when == when || (paper.when == "both" && when != "block"))
        add("questionnaire " + paper.name, item_min * static_cast<double>(paper.items.size()));
  };
  add("information, consent, choice of hand and finger, questions", consent_min);
  if (design.calibrates) add("set-up, 16 to 40 slides straight ahead", calibration_min);
  add_questionnaires("before");
  bool is_first = true;
  for (std::size_t i = 0; i < schedule.blocks.size(); ++i) {
    const Block& block = schedule.blocks[i];
    if (block.trials.empty()) continue;
    if (!std::exchange(is_first, false)) add("break", design.break_minutes);
    const double reaches = block.kind == BlockKind::noticeability ? 2.0 : 1.0;
    add(format("block %zu: %s, %zu trials", i, name_of(block.kind).c_str(), block.trials.size()),
        static_cast<double>(block.trials.size()) * reaches * design.trial_s * min_per_s);
    if (block.kind == BlockKind::reaches) add_questionnaires("block");
  }
  add_questionnaires("after");
  add("debriefing, without the names of the conditions", 0.0);
  return text;
}

std::string name_of(BlockKind kind) {
  constexpr const char* names[] = {"practice", "reaches", "noticeability"};
  return names[static_cast<std::size_t>(kind)];
}

std::string blinded_name(const Design& design, unsigned participant, BlockKind kind, unsigned condition) {
  return kind == BlockKind::reaches ? letter_of(design, participant, condition) : name_of(kind);
}

std::string design_text(const Design& design) {
  const Schedule first = schedule_of(design, 1);
  std::string text = design.title + "\nSHA-256 " + design.sha256 + "\n\nMinute at which each part begins:\n" +
                     plan_text(design, first);
  std::size_t trials = 0;
  for (std::size_t b = 1; b < first.blocks.size(); ++b) trials += first.blocks[b].trials.size();
  text += format("%u participants, each with %zu trials and %u practice trials\n", design.participants, trials,
                 design.practice_trials);
  text += balance_text(design) + "\n";
  for (unsigned p = 1; p <= design.participants; ++p) {
    const Schedule schedule = schedule_of(design, p);
    text += format("sub-%02u  ", p) + (design.levels.empty() ? "" : design.levels[schedule.level] + "  ") +
            (schedule.order.empty() ? "all conditions in each block" : letters_of(design, p, schedule.order)) + "\n";
  }
  return text +
         "\nConditions are shown as letters before unblinding. hrt-experiment has been run with simulated participants "
         "only.\n";
}

}  // namespace hrt::experiment

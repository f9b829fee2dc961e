// The planned order of conditions and trials: a pure function of the design and the participant's number.
#pragma once

#include <string>
#include <vector>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

struct PlannedTrial {
  unsigned number;     ///< position in the block, from 1
  unsigned condition;  ///< index of the condition; catch trials have one too, for the analysis of their answers
  unsigned pair;       ///< index of the pair; noticeability: index of the QUEST+ run
  bool is_catch;       ///< also true in practice
};

enum class BlockKind { practice, reaches, noticeability };

struct Block {
  BlockKind kind;
  std::vector<PlannedTrial> trials;
};

struct Schedule {
  unsigned level;               ///< index of the level of the between-participants factor
  std::vector<unsigned> order;  ///< order of the conditions; empty for random_in_blocks
  std::vector<Block> blocks;
};

/// Returns orders in which each of `count` conditions directly precedes each other condition equally often (Williams
/// 1949): `count` orders if `count` is 1 or even, otherwise twice as many.
std::vector<std::vector<unsigned>> williams_orders(unsigned count);

/// Returns the schedule of a participant, whose number is counted from 1.
Schedule schedule_of(const Design& design, unsigned participant);

/// Returns the time plan of a session, one line per part with the minute at which it begins:
/// "| 12 | block 1: reaches, 13 trials |".
std::string plan_text(const Design& design, const Schedule& schedule);

std::string name_of(BlockKind kind);

/// Returns the name of a condition before unblinding: its letter; for practice and noticeability, the kind of block.
std::string blinded_name(const Design& design, unsigned participant, BlockKind kind, unsigned condition);

/// Returns a summary of the design: trials, minutes, balance, order of each participant by letters.
std::string design_text(const Design& design);

}  // namespace hrt::experiment

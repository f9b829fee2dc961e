// The order of conditions and trials: a pure function of the design and the participant's number.
#pragma once

#include <string>
#include <vector>

#include "samples/experiment/design/design.h"

namespace hrt::experiment {

struct PlannedTrial {
  unsigned number;     ///< within the block, from 1
  unsigned condition;  ///< index; of catch trials too, whose plate rests all the same
  unsigned pair;       ///< index; in noticeability the run
  bool is_catch;
};

enum class BlockKind { practice, reaches, noticeability };

struct Block {
  BlockKind kind;
  std::vector<PlannedTrial> trials;
};

struct Schedule {
  unsigned level;               ///< of the factor between people
  std::vector<unsigned> order;  ///< of conditions; empty under random_in_blocks
  std::vector<Block> blocks;
};

/// Orders in which each of `count` conditions precedes each other one equally often (Williams 1949): `count`
/// orders of an even number, twice as many of an odd one.
std::vector<std::vector<unsigned>> williams_orders(unsigned count);

/// `participant`: from 1.
Schedule schedule_of(const Design& design, unsigned participant);

/// The plan of a session, one line for each part: "| 12 | block 1: reaches, 13 trials |", with the minute at which it
/// begins.
std::string plan_text(const Design& design, const Schedule& schedule);

/// Name of the kind, in files.
std::string name_of(BlockKind kind);

/// Name of a condition until it is unblinded: its letter, or the kind of a block whose condition the design
/// reveals.
std::string blinded_name(const Design& design, unsigned participant, BlockKind kind, unsigned condition);

/// The design for people: trials, minutes, balance, each participant's order, by letters.
std::string design_text(const Design& design);

}  // namespace hrt::experiment

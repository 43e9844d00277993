#include "errors/tracked/crossings.hpp"

#include <new>

namespace meshbound {
namespace {

/// Places that a supply gets at a time; they divide a block. Few would have threads wait for each other, many would lie idle.
constexpr std::uint32_t places_at_once = 256;

} // namespace

void Crossings::clear(std::uint32_t current, Supply& supply) {
    std::uint32_t id = on_[current];
    while (id != no_index) {
        Crossing& crossing = at(id);
        const std::uint32_t sibling = crossing.sibling;
        crossing.sibling = supply.unused_;
        supply.unused_ = id;
        id = sibling;
    }
    on_[current] = no_index;
}

std::uint32_t Crossings::add(const Crossing& crossing, Supply& supply) {
    if (supply.unused_ == no_index && supply.fresh_ == supply.end_) refill(supply);
    const bool used = supply.unused_ != no_index;
    const std::uint32_t id = used ? supply.unused_ : supply.fresh_++;
    Crossing& place = at(id);
    if (used) supply.unused_ = place.sibling;
    place = crossing;
    place.sibling = on_[crossing.current];
    on_[crossing.current] = id;
    return id;
}

void Crossings::link(std::uint32_t original, std::uint32_t before, std::uint32_t after) {
    (before == no_index ? chains_[original].first : at(before).next) = after;
    (after == no_index ? chains_[original].last : at(after).previous) = before;
}

void Crossings::refill(Supply& supply) {
    static_assert(block_size % places_at_once == 0); // the first place of a block makes room for all
    const std::lock_guard lock(mutex_);
    if (returned_ != no_index) {
        supply.unused_ = returned_;
        returned_ = at(returned_).next;
        return;
    }
    const std::uint32_t block = size_ >> block_bits;
    if (block == most_blocks) throw std::bad_alloc();
    if (!blocks_[block]) blocks_[block].reset(new Crossing[block_size]);
    supply.fresh_ = size_;
    supply.end_ = size_ += places_at_once;
}

/// Puts what was never used in front of the rest of the supply, and gives both back as one chain.
void Crossings::take_back(Supply& supply) {
    for (; supply.fresh_ != supply.end_; ++supply.fresh_) {
        at(supply.fresh_).sibling = supply.unused_;
        supply.unused_ = supply.fresh_;
    }
    if (supply.unused_ == no_index) return;
    const std::lock_guard lock(mutex_);
    at(supply.unused_).next = returned_;
    returned_ = supply.unused_;
}

} // namespace meshbound

#include "crossings.hpp"

#include <new>
#include <utility>

namespace meshbound {
namespace {

/// Places that a supply gets at a time; a fraction of a block. Few would have threads wait for each other, many would lie idle.
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
    const std::lock_guard lock(mutex_);
    if (returned_ != no_index) {
        std::swap(supply.unused_, returned_);
        return;
    }
    if (size_ > no_index - 2 * places_at_once) throw std::bad_alloc();
    const std::uint64_t place = std::uint64_t{size_} + (std::uint64_t{1} << first_block_bits);
    if (std::has_single_bit(place)) // the first of its block
        blocks_[static_cast<std::size_t>(std::bit_width(place) - 1 - first_block_bits)].reset(new Crossing[place]);
    supply.fresh_ = size_;
    supply.end_ = size_ += places_at_once;
}

/// Chains what is left of a supply before what was given back earlier.
void Crossings::take_back(Supply& supply) {
    for (; supply.fresh_ != supply.end_; ++supply.fresh_) {
        at(supply.fresh_).sibling = supply.unused_;
        supply.unused_ = supply.fresh_;
    }
    if (supply.unused_ == no_index) return;
    std::uint32_t last = supply.unused_;
    while (at(last).sibling != no_index) last = at(last).sibling;
    const std::lock_guard lock(mutex_);
    at(last).sibling = returned_;
    returned_ = supply.unused_;
}

} // namespace meshbound

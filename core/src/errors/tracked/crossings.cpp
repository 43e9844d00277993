#include "errors/tracked/crossings.hpp"

#include <new>

namespace meshbound {
namespace {

/// Slots that a free list gets at a time; a divisor of the block size. Fewer would make threads wait for each other,
/// more would lie idle.
constexpr std::uint32_t slots_per_refill = 256;

} // namespace

void Crossings::clear(std::uint32_t current, FreeList& free_list) {
    std::uint32_t id = on_[current];
    while (id != no_index) {
        Crossing& crossing = at(id);
        const std::uint32_t sibling = crossing.sibling;
        crossing.sibling = free_list.unused_;
        free_list.unused_ = id;
        id = sibling;
    }
    on_[current] = no_index;
}

std::uint32_t Crossings::add(const Crossing& crossing, FreeList& free_list) {
    if (free_list.unused_ == no_index && free_list.fresh_ == free_list.end_) refill(free_list);
    const bool used = free_list.unused_ != no_index;
    const std::uint32_t id = used ? free_list.unused_ : free_list.fresh_++;
    Crossing& slot = at(id);
    if (used) free_list.unused_ = slot.sibling;
    slot = crossing;
    slot.sibling = on_[crossing.current];
    on_[crossing.current] = id;
    return id;
}

void Crossings::link(std::uint32_t original, std::uint32_t before, std::uint32_t after) {
    (before == no_index ? lists_[original].first : at(before).next) = after;
    (after == no_index ? lists_[original].last : at(after).previous) = before;
}

void Crossings::refill(FreeList& free_list) {
    static_assert(block_size % slots_per_refill == 0); // the first slot of a block allocates all of it
    const std::lock_guard lock(mutex_);
    if (returned_ != no_index) {
        free_list.unused_ = returned_;
        returned_ = at(returned_).next;
        return;
    }
    const std::uint32_t block = size_ >> block_bits;
    if (block == most_blocks) throw std::bad_alloc();
    if (!blocks_[block]) blocks_[block].reset(new Crossing[block_size]);
    free_list.fresh_ = size_;
    free_list.end_ = size_ += slots_per_refill;
}

/// Links what was never used and what was released into one list, and gives it back.
void Crossings::reclaim(FreeList& free_list) {
    for (; free_list.fresh_ != free_list.end_; ++free_list.fresh_) {
        at(free_list.fresh_).sibling = free_list.unused_;
        free_list.unused_ = free_list.fresh_;
    }
    if (free_list.unused_ == no_index) return;
    const std::lock_guard lock(mutex_);
    at(free_list.unused_).next = returned_;
    returned_ = free_list.unused_;
}

} // namespace meshbound

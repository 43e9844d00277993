#pragma once

namespace meshbound {

/// Has the processor fetch from memory what is needed soon, without waiting for it. WebAssembly has no such instruction: there
/// a byte is read, which keeps nothing waiting either, as nothing follows from it. So it must be one that may be read.
/// Always inline: GCC takes a function that only fetches for one without effect, and leaves it out.
[[gnu::always_inline]] inline void fetch(const void* address) {
#ifdef __wasm__
    static_cast<void>(*static_cast<const volatile char*>(address));
#else
    __builtin_prefetch(address);
#endif
}

} // namespace meshbound

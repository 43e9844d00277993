#pragma once

namespace meshbound {

/// Prefetches a cache line. WebAssembly has no such instruction: there a byte is read and thrown away, so the address
/// must be readable. Always inline: GCC takes a function that does nothing but prefetch for one without effect, and
/// removes the call.
[[gnu::always_inline]] inline void prefetch(const void* address) {
#ifdef __wasm__
    static_cast<void>(*static_cast<const volatile char*>(address));
#else
    __builtin_prefetch(address);
#endif
}

} // namespace meshbound

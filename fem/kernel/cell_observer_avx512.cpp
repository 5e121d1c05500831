#define REBOUND_KERNEL_WIDTH 8
#define REBOUND_OBSERVER_SYMBOL cell_observer_avx512
#include "fem/kernel/cell_observer.inl"

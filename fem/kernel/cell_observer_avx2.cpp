#define REBOUND_KERNEL_WIDTH 4
#define REBOUND_OBSERVER_SYMBOL cell_observer_avx2
#include "fem/kernel/cell_observer.inl"

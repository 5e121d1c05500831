#define REBOUND_KERNEL_WIDTH 2
#define REBOUND_OBSERVER_SYMBOL cell_observer_baseline
#include "fem/kernel/cell_observer.inl"

#define REBOUND_KERNEL_WIDTH 2
#define REBOUND_KERNEL_NAME "baseline"
#define REBOUND_KERNEL_SYMBOL cell_kernel_baseline
#include "fem/kernel/cell_kernel.inl"

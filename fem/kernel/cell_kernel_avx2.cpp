#define REBOUND_KERNEL_WIDTH 4
#define REBOUND_KERNEL_NAME "avx2"
#define REBOUND_KERNEL_SYMBOL cell_kernel_avx2
#include "fem/kernel/cell_kernel.inl"

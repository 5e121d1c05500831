#define REBOUND_KERNEL_WIDTH 8
#define REBOUND_KERNEL_NAME "avx512"
#define REBOUND_KERNEL_SYMBOL cell_kernel_avx512
#include "fem/kernel/cell_kernel.inl"

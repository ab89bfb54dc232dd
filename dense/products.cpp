#define JOINTID_COMPILED_ONCE
#include "dense/products.hpp"

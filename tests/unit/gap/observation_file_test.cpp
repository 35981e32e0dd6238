#include "scheduler/gap/observation_file.h"
#include <gtest/gtest.h>

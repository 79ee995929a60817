#pragma once
#include "IPluginContactModelV3_3_0.h"

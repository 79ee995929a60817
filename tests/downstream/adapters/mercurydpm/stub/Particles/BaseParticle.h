#pragma once
#include "Interactions/BaseInteraction.h"

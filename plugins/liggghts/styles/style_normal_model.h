#include "normal_model_platen.h"

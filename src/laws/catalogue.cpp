// All laws, compiled once for the program (platen/law/catalogue.hpp).

#include "platen/law/catalogue.hpp"
#include "platen/law/every_law.hpp"

/// regolab: the client. See `regolab --help`.
#include <string>
#include <vector>

#include "client/program.h"

int main(int argc, char** argv) { return regolab::client::run_program(std::vector<std::string>(argv + 1, argv + argc)); }

// digest_probe EXPERIMENTS: does a fixed amount of tick work of every sort and prints fingerprints of the results. The
// output depends on the sources and the experiments alone: not on compiler, optimisation or processor.
#include <cstdio>

#include "tests/digest_probe/work.h"

int main(int count, char** words) {
  if (count != 2) {
    std::fprintf(stderr, "usage: digest_probe EXPERIMENTS\n");
    return 2;
  }
  ganglion::probe::probe_math();
  ganglion::probe::probe_draws();
  return ganglion::probe::probe_experiments(words[1]) ? 0 : 1;
}

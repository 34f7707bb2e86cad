/* Prints numbers of a report: report FILE POINTER... */
#include <kinestat.h>
#include <stdio.h>

static int fail(int status) {
  fputs(kinestat_message_text(), stderr);
  return status;
}

int main(int count, char** words) {
  kinestat_mechanism* mechanism = NULL;
  kinestat_report* report = NULL;
  int status;
  int i;
  if (count < 3) {
    fprintf(stderr, "usage: report FILE POINTER...\n");
    return KINESTAT_USAGE;
  }
  status = kinestat_read_file(words[1], &mechanism);
  if (status != KINESTAT_DONE) {
    return fail(status);
  }
  status = kinestat_analyze(mechanism, &report);
  if (report == NULL) {
    kinestat_free_mechanism(mechanism);
    return fail(status);
  }
  for (i = 2; i < count; ++i) {
    double number;
    const int found = kinestat_number(report, words[i], &number);
    if (found == KINESTAT_DONE) {
      printf("%s = %.10g\n", words[i], number);
    } else {
      status = fail(found);
    }
  }
  kinestat_free_report(report);
  kinestat_free_mechanism(mechanism);
  return status;
}

/* C interface for other programs: mechanism files are read, analysed, and evaluated for many values
 * of their parameters. C99; needs only this header and the library libkinestat.
 *
 * A function that can fail returns KINESTAT_DONE, or the exit status with which the program
 * `kinestat` would end, and then leaves its output arguments unchanged. The functions
 * `kinestat_message...` give the messages, including warnings, of the last such call of their
 * thread.
 *
 * Nothing here prints, ends the process or throws. An object can be used by one thread at a time,
 * different objects by different threads. Texts are UTF-8, end with a null, and live as long as the
 * object from which they come. Numbers are in the units that the mechanism file sets; in a file
 * without units, angles are in radians and lengths in metres.
 *
 * Functions and values may be added; none is changed or removed as long as the library keeps the
 * number in its name, libkinestat.so.0. */
#ifndef KINESTAT_H
#define KINESTAT_H

#include <stddef.h>

#if defined(__GNUC__)
#define KINESTAT_API __attribute__((visibility("default")))
#else
#define KINESTAT_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* The exit statuses of the program. */
enum kinestat_status {
  KINESTAT_DONE = 0,         /* warnings do not count */
  KINESTAT_CHECK_FAILED = 1, /* done, but the report does not match a published value of the file */
  KINESTAT_USAGE = 2,        /* a wrong argument: an unknown name, a null */
  KINESTAT_WRONG_INPUT = 3,  /* the mechanism file is wrong */
  KINESTAT_ENVIRONMENT = 4,  /* a file that cannot be read, or no memory left */
  KINESTAT_NO_ANSWER = 5,    /* a requested case has no answer */
  KINESTAT_BUG = 70          /* of this library: please report it */
};

/* A mechanism file with the values of its parameters. */
typedef struct kinestat_mechanism kinestat_mechanism;

/* What `kinestat analyze` reports of a mechanism. */
typedef struct kinestat_report kinestat_report;

/* The recorded solution of one case, to be evaluated for many values of some parameters. */
typedef struct kinestat_tape kinestat_tape;

/* The version of the library, as "1.2.3". */
KINESTAT_API const char* kinestat_version(void);

/* Reads a mechanism file and binds it; free the mechanism with kinestat_free_mechanism. */
KINESTAT_API int kinestat_read_file(const char* path, kinestat_mechanism** mechanism);

/* The same for a text of `length` bytes; `name` stands for the path in messages and reports. */
KINESTAT_API int kinestat_read_text(const char* text,
                                    size_t length,
                                    const char* name,
                                    kinestat_mechanism** mechanism);

/* A null pointer is ignored. */
KINESTAT_API void kinestat_free_mechanism(kinestat_mechanism* mechanism);

/* Sets a parameter of the file from now on, as `kinestat analyze --set` does: to a number, a number
 * with a unit, or an expression of other parameters, "24", "20 deg", "2*N1". Only the value itself
 * is checked here, since other parameters may have to change with it; kinestat_analyze and
 * kinestat_record check whether it suits the mechanism. */
KINESTAT_API int kinestat_set(kinestat_mechanism* mechanism,
                              const char* parameter,
                              const char* value);

/* Kinds of names in a mechanism. */
enum kinestat_names {
  KINESTAT_PARAMETERS = 0,
  KINESTAT_ACTUATORS = 1,
  KINESTAT_CASES = 2 /* those of the file, then its gears */
};

/* The name at an index, from 0, in the order of the file; null past the last, and where `names` is
 * not a kinestat_names. */
KINESTAT_API const char* kinestat_name(const kinestat_mechanism* mechanism,
                                       int names,
                                       size_t index);

/* Analyses all cases; free the report with kinestat_free_report. KINESTAT_CHECK_FAILED and
 * KINESTAT_NO_ANSWER also give a report. */
KINESTAT_API int kinestat_analyze(const kinestat_mechanism* mechanism, kinestat_report** report);

/* A null pointer is ignored. */
KINESTAT_API void kinestat_free_report(kinestat_report* report);

/* The report as JSON, with the schema that `kinestat schema report` prints. */
KINESTAT_API const char* kinestat_json(const kinestat_report* report);

/* The number at a place of the report, given as a JSON Pointer: "/cases/M1/ratio". NaN where the
 * report has null because there is no value; 1 and 0 for true and false. */
KINESTAT_API int kinestat_number(const kinestat_report* report,
                                 const char* pointer,
                                 double* number);

/* Records one case (by its label; null: the only one) for many values of its inputs, which are
 * parameters of the file. The outputs are the names that `report` of a section `sweep` accepts:
 * "ratio", "torque_ratio", "efficiency", "recirculation", actuators, "COUPLING.FREEDOM" and
 * "COUPLING.ACTION"; none (and null): the default outputs of a sweep. The tape does not depend on
 * the mechanism afterwards; free it with kinestat_free_tape. */
KINESTAT_API int kinestat_record(const kinestat_mechanism* mechanism,
                                 const char* label,
                                 const char* const* inputs,
                                 size_t input_count,
                                 const char* const* outputs,
                                 size_t output_count,
                                 kinestat_tape** tape);

/* A null pointer is ignored. */
KINESTAT_API void kinestat_free_tape(kinestat_tape* tape);

/* The number of outputs, their names, and the units of inputs and outputs; the unit of a bare
 * number is "". Null past the last. */
KINESTAT_API size_t kinestat_output_count(const kinestat_tape* tape);
KINESTAT_API const char* kinestat_output_name(const kinestat_tape* tape, size_t output);
KINESTAT_API const char* kinestat_output_unit(const kinestat_tape* tape, size_t output);
KINESTAT_API const char* kinestat_input_unit(const kinestat_tape* tape, size_t input);

/* Evaluates the tape for `states` states. `inputs` has the inputs of the first state, then those of
 * the second, and so on; `outputs` receives the outputs likewise; NaN is an output without a value.
 * `statuses`, if not null, receives a word for each state: "solved", or the reason why it is not:
 * "locked", "no_ratio", an error code. These texts live as long as the tape. Outputs equal those of
 * an analysis of each state, except for rounding; a state for which the recording is not valid is
 * analysed again, which takes thousands of times longer. */
KINESTAT_API int kinestat_play(kinestat_tape* tape,
                               const double* inputs,
                               size_t states,
                               double* outputs,
                               const char** statuses);

/* Whether states are evaluated from the recording; if no tape can be made of the case, each state
 * is analysed instead. Known after the first call of kinestat_play. */
KINESTAT_API int kinestat_is_played(const kinestat_tape* tape);

/* One message; the texts live until the next call of the thread that produces messages. */
typedef struct kinestat_message {
  int is_error;     /* 0: a warning */
  const char* code; /* "E0312"; explained by `kinestat explain E0312` */
  const char* text;
  const char* hint; /* what to do; may be empty */
  const char* file; /* as given; empty: the message concerns no file */
  int line;         /* from 1; 0: the whole file */
  int column;       /* in characters from 1 */
  int length;       /* in characters */
} kinestat_message;

/* The number of messages of the last call of this thread that returned a status. */
KINESTAT_API size_t kinestat_message_count(void);

/* The message at an index, from 0; past the last, returns false and leaves `message` unchanged. */
KINESTAT_API int kinestat_message_at(size_t index, kinestat_message* message);

/* All messages as the program prints them, with the line of the file and the place marked in it;
 * empty if there are none. */
KINESTAT_API const char* kinestat_message_text(void);

#ifdef __cplusplus
}
#endif

#endif /* KINESTAT_H */

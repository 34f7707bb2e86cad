/* What other programs call: mechanism files read, analysed, and played for many values of their
 * parameters. C99; nothing but this header and the library libkinestat is needed.
 *
 * A function that can fail answers KINESTAT_DONE, or the exit status that the program `kinestat`
 * would end with, and what it was given to fill in stays as it was. What there is to say, warnings
 * too, the functions `kinestat_message...` tell of the last such call of their thread.
 *
 * Nothing here prints, ends the process or throws. An object may be used by one thread at a time,
 * different objects by different threads. Texts are UTF-8, end with a null, and live as long as the
 * object that they are asked of. Numbers are in the units that the mechanism file writes; the angle
 * of a file without units is the radian, its length the metre.
 *
 * Functions and values may be added; none is changed or removed as long as the library keeps the
 * number of its name, libkinestat.so.0. */
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
  KINESTAT_CHECK_FAILED = 1, /* done, but the report misses a published value of the file */
  KINESTAT_USAGE = 2,        /* an argument: an unknown name, a null */
  KINESTAT_WRONG_INPUT = 3,  /* the mechanism file */
  KINESTAT_ENVIRONMENT = 4,  /* a file that cannot be read, memory that is used up */
  KINESTAT_NO_ANSWER = 5,    /* a case that was asked for has no answer */
  KINESTAT_BUG = 70          /* of this library: please report it */
};

/* A mechanism file with the values of its parameters. */
typedef struct kinestat_mechanism kinestat_mechanism;

/* What `kinestat analyze` reports of a mechanism. */
typedef struct kinestat_report kinestat_report;

/* The solution of one case, recorded, to be played for many values of some parameters. */
typedef struct kinestat_tape kinestat_tape;

/* The version of the library, as "1.2.3". */
KINESTAT_API const char* kinestat_version(void);

/* Reads a mechanism file and binds it; free the mechanism with kinestat_free_mechanism. */
KINESTAT_API int kinestat_read_file(const char* path, kinestat_mechanism** mechanism);

/* The same of a text of so many bytes; `name` stands for the path in messages and reports. */
KINESTAT_API int kinestat_read_text(const char* text,
                                    size_t length,
                                    const char* name,
                                    kinestat_mechanism** mechanism);

/* A null is free already. */
KINESTAT_API void kinestat_free_mechanism(kinestat_mechanism* mechanism);

/* Gives a parameter of the file another value from now on, as `kinestat analyze --set` does: a
 * number, a number with a unit, or an expression of other parameters, "24", "20 deg", "2*N1". Only
 * the value itself is judged here, since others may have to change with it: whether the mechanism
 * can have it kinestat_analyze and kinestat_record tell. */
KINESTAT_API int kinestat_set(kinestat_mechanism* mechanism,
                              const char* parameter,
                              const char* value);

/* What a mechanism has names for. */
enum kinestat_names {
  KINESTAT_PARAMETERS = 0,
  KINESTAT_ACTUATORS = 1,
  KINESTAT_CASES = 2 /* those of the file, then its gears */
};

/* The name of that index, from 0, in the order of the file; null past the last, and for what is no
 * kinestat_names. */
KINESTAT_API const char* kinestat_name(const kinestat_mechanism* mechanism,
                                       int names,
                                       size_t index);

/* Analyses all cases; free the report with kinestat_free_report. KINESTAT_CHECK_FAILED and
 * KINESTAT_NO_ANSWER have a report, too. */
KINESTAT_API int kinestat_analyze(const kinestat_mechanism* mechanism, kinestat_report** report);

/* A null is free already. */
KINESTAT_API void kinestat_free_report(kinestat_report* report);

/* The report as JSON, by the schema that `kinestat schema report` prints. */
KINESTAT_API const char* kinestat_json(const kinestat_report* report);

/* The number at a place of the report, which is a JSON Pointer: "/cases/M1/ratio". NaN where the
 * report has null, for what has no value; 1 and 0 for true and false. */
KINESTAT_API int kinestat_number(const kinestat_report* report,
                                 const char* pointer,
                                 double* number);

/* Records one case (by its label; null: the only one) for many values of its inputs, which are
 * parameters of the file. The outputs are what `report` of a section `sweep` may name: "ratio",
 * "torque_ratio", "efficiency", "recirculation", actuators, "COUPLING.FREEDOM" and
 * "COUPLING.ACTION"; none (and null): the outputs that a sweep would choose. The tape keeps nothing
 * of the mechanism; free it with kinestat_free_tape. */
KINESTAT_API int kinestat_record(const kinestat_mechanism* mechanism,
                                 const char* label,
                                 const char* const* inputs,
                                 size_t input_count,
                                 const char* const* outputs,
                                 size_t output_count,
                                 kinestat_tape** tape);

/* A null is free already. */
KINESTAT_API void kinestat_free_tape(kinestat_tape* tape);

/* How many outputs there are, how one is called, and in what unit inputs and outputs are counted;
 * the unit of a bare number is "". Null past the last. */
KINESTAT_API size_t kinestat_output_count(const kinestat_tape* tape);
KINESTAT_API const char* kinestat_output_name(const kinestat_tape* tape, size_t output);
KINESTAT_API const char* kinestat_output_unit(const kinestat_tape* tape, size_t output);
KINESTAT_API const char* kinestat_input_unit(const kinestat_tape* tape, size_t input);

/* Plays the tape for so many states. `inputs` has the inputs of the first state, then those of the
 * second, and so on, `outputs` takes the outputs likewise; NaN is an output without a value.
 * `statuses`, if it is not null, takes a word for each state: "solved", or what keeps it from being
 * so: "locked", "no_ratio", a code of an error. These texts live as long as the tape. Outputs are
 * those of an analysis of each state, but for rounding; a state for which what was recorded does
 * not hold is analysed anew, which takes thousands of times longer. */
KINESTAT_API int kinestat_play(kinestat_tape* tape,
                               const double* inputs,
                               size_t states,
                               double* outputs,
                               const char** statuses);

/* Whether states are played; otherwise, where no tape can be made of the case, each is analysed.
 * Known once some were. */
KINESTAT_API int kinestat_is_played(const kinestat_tape* tape);

/* One message; the texts live until the next call of the thread that has messages. */
typedef struct kinestat_message {
  int is_error;     /* 0: a warning */
  const char* code; /* "E0312"; `kinestat explain E0312` tells more */
  const char* text;
  const char* hint; /* what to do; may be empty */
  const char* file; /* as it was given; empty: the message is about no file */
  int line;         /* from 1; 0: the whole file */
  int column;       /* in characters from 1 */
  int length;       /* in characters */
} kinestat_message;

/* The messages of the last call of this thread that answers a status. */
KINESTAT_API size_t kinestat_message_count(void);

/* The message of that index, from 0; false past the last, where it stays as it is. */
KINESTAT_API int kinestat_message_at(size_t index, kinestat_message* message);

/* All of them as the program prints them, with the line of the file and the place marked in it;
 * empty if there are none. */
KINESTAT_API const char* kinestat_message_text(void);

#ifdef __cplusplus
}
#endif

#endif /* KINESTAT_H */

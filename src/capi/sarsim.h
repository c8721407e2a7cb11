/* The C interface of Sarsim, a radar echo simulator: libsarsim.so.0.
 *
 *   cc program.c -lsarsim
 *
 * docs/formats/c-interface.md has a whole program. What follows holds for every function.
 *
 * Status. Every function that can fail returns a sarsim_status. SARSIM_OK is 0. What the call made is in its last
 * arguments but one; where it fails they are set to NULL, or left alone where they are memory of the caller's.
 *
 * Problems. The last argument of such a function takes a list of everything that is wrong or worth knowing: errors where
 * it failed, warnings and notes where it did not, NULL where there is nothing. It is freed with sarsim_problems_free. The
 * argument may be NULL, where nobody asks.
 *
 * Handles. What ends in `_free` gives a handle back; NULL is allowed there. A handle keeps what it needs: a plan may be
 * used after its scene was freed. Strings that a function returns belong to the handle and live as long as it does,
 * unless the function says otherwise.
 *
 * Text is UTF-8 and ends with a zero byte. Names of files are the bytes that the system has for them.
 *
 * Units are SI and radians. Complex samples are pairs of numbers, I before Q, rows one after the other: the memory of an
 * array of C's `float complex` or `double complex`, of NumPy's complex64 or complex128.
 *
 * Threads. All functions may be called from many threads at once. One handle may be used by many threads at once as long
 * as none of them changes it (the functions that take it without `const`) or frees it. A sarsim_stop is an exception: it
 * may be requested from any thread and from a signal handler.
 *
 * The library writes nothing to standard streams, ends no process, installs no signal handler, changes no locale and lets
 * no exception out.
 *
 * Structures begin with `struct_size`. Set it to sizeof the structure and clear the rest, as SARSIM_INIT does:
 *
 *   sarsim_work work = SARSIM_INIT(sarsim_work);
 *
 * Later versions add members at the end, which programs compiled before then do not know; a library that is older than the
 * program refuses members that it does not know, unless they are zero.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#if defined(__GNUC__)
#define SARSIM_API __attribute__((visibility("default")))
#else
#define SARSIM_API
#endif

/* A cleared structure that knows its size; for the initialisation of a variable. */
#define SARSIM_INIT(type) {sizeof(type)}

/* ------------------------------------------------------------------------------------------------------ Versions */

/* Counts up with every function and member that is added. What a program was compiled for works with any library
 * libsarsim.so.0 whose number is not smaller. */
#define SARSIM_ABI_VERSION 1

/* The number of the library that runs. */
SARSIM_API int sarsim_abi_version(void);
/* Version of the program that the library belongs to: "0.1.0". Lives for ever. */
SARSIM_API const char* sarsim_version(void);

/* ------------------------------------------------------------------------------------------------ Status and text */

typedef int sarsim_status;
enum {
  SARSIM_OK = 0,           /* Done. */
  SARSIM_BAD_INPUT = 1,    /* Mistakes in a scene, a file or a value; all of them are in the list. */
  SARSIM_STOPPED = 2,      /* As a sarsim_stop asked. Nothing is left behind; memory of the caller's is half filled. */
  SARSIM_NO_MEMORY = 3,    /* The list may be NULL then. */
  SARSIM_FAILED = 4,       /* A failure of the world: a disk that is full, a folder that cannot be written. */
  SARSIM_BAD_ARGUMENT = 5  /* A mistake in the calling program: NULL, an index out of range, an unknown structure. */
};

/* A status in a word: "ok", "bad input", "stopped", "no memory", "failed", "bad argument". Lives for ever. */
SARSIM_API const char* sarsim_status_word(sarsim_status status);

/* A text that a function made. */
typedef struct sarsim_text sarsim_text;
SARSIM_API void sarsim_text_free(sarsim_text* text);
/* Its characters, with a zero byte behind them; "" for NULL. */
SARSIM_API const char* sarsim_text_chars(const sarsim_text* text);
/* Number of bytes without that zero; 0 for NULL. */
SARSIM_API size_t sarsim_text_length(const sarsim_text* text);

/* ------------------------------------------------------------------------------------------------------ Problems */

/* What was found: errors before warnings before notes. */
typedef struct sarsim_problems sarsim_problems;

typedef int sarsim_severity;
enum {
  SARSIM_ERROR = 0,   /* The call failed for it. */
  SARSIM_WARNING = 1, /* Probably not what was meant. */
  SARSIM_NOTE = 2     /* Worth knowing. */
};

/* One thing that is wrong. Texts are "" and numbers 0 where there is nothing to say. */
typedef struct sarsim_problem {
  size_t struct_size;
  sarsim_severity severity;
  const char* message;  /* What is wrong, in words. */
  const char* found;    /* The text or value that is to blame. */
  const char* expected; /* What would have been right. */
  const char* hint;     /* How to mend it. */
  const char* file;     /* Where it stands, with line and column (in bytes) from 1. */
  size_t line;
  size_t column;
  const char* object;  /* What it is about: "platform", "target", "cloud", "surface", "radar", "simulation", "geometry",
                          "options", "world", "atmosphere". */
  size_t object_index; /* Of the objects of this kind, from 0. */
  const char* field;   /* "bandwidth_hz". */
  size_t count;        /* How often the same cause was met, at least 1. */
  const char* text;    /* All of it, as the command prints it: "a.toml:3:9: error: ..." */
} sarsim_problem;

SARSIM_API void sarsim_problems_free(sarsim_problems* problems);
/* How many there are; 0 for NULL. */
SARSIM_API size_t sarsim_problems_count(const sarsim_problems* problems);
/* Number `index` of them. SARSIM_BAD_ARGUMENT where there is none. */
SARSIM_API sarsim_status sarsim_problems_get(const sarsim_problems* problems, size_t index, sarsim_problem* problem);

/* ----------------------------------------------------------------------------------------------------------- Work */

/* A request to end work early. It stays requested. */
typedef struct sarsim_stop sarsim_stop;
SARSIM_API sarsim_status sarsim_stop_new(sarsim_stop** stop, sarsim_problems** problems);
/* Not before the calls that it was given to have returned. */
SARSIM_API void sarsim_stop_free(sarsim_stop* stop);
/* Ends the work that it was given to, within about the time of one row on each thread. From any thread, from a callback
 * and from a signal handler. */
SARSIM_API void sarsim_stop_request(sarsim_stop* stop);

/* Told how far work has come: `done` of `total` units (mostly rows) of a stage, named for people. Called on the thread
 * that called the function, never from two threads at once, and not after the function has returned. It may call
 * sarsim_stop_request; it must not free what the function works on, nor leave by longjmp or an exception. */
typedef void (*sarsim_progress)(void* user, const char* stage, uint64_t done, uint64_t total);

/* How work is done. Nothing here changes a bit of the result. NULL in place of it is the same as all zeros. */
typedef struct sarsim_work {
  size_t struct_size;
  unsigned threads;         /* 0: one for each core. */
  const sarsim_stop* stop;  /* NULL: nothing stops it. */
  sarsim_progress progress; /* NULL: nobody looks on. */
  void* user;               /* For `progress`. */
} sarsim_work;

/* --------------------------------------------------------------------------------------------------------- Scenes */

/* A scene as it was read and, perhaps, changed. */
typedef struct sarsim_scene sarsim_scene;

/* How a scene is read. NULL in place of it is the same as all zeros. */
typedef struct sarsim_scene_options {
  size_t struct_size;
  const char* const* let; /* "NAME=VALUE": numbers or expressions in place of those in [let] of format 2. */
  size_t let_count;
} sarsim_scene_options;

/* Reads a scene, in either language, with the files that it includes and names. SARSIM_BAD_INPUT with all mistakes of the
 * text; remarks where it can be used. Whether it can be simulated, sarsim_scene_check says. */
SARSIM_API sarsim_status sarsim_scene_read_file(const char* path, const sarsim_scene_options* options,
                                                sarsim_scene** scene, sarsim_problems** problems);
/* The same from `length` bytes. `name` is that of a file that need not exist: problems have it as their place, and
 * included files and data files are looked for in its folder. NULL: "scene", in the current folder. */
SARSIM_API sarsim_status sarsim_scene_read_text(const char* text, size_t length, const char* name,
                                                const sarsim_scene_options* options, sarsim_scene** scene,
                                                sarsim_problems** problems);
SARSIM_API sarsim_status sarsim_scene_copy(const sarsim_scene* scene, sarsim_scene** copy, sarsim_problems** problems);
SARSIM_API void sarsim_scene_free(sarsim_scene* scene);

typedef int sarsim_language;
enum {
  SARSIM_FORMAT_2 = 0, /* TOML: docs/formats/scene.md. */
  SARSIM_SCRIPT = 1    /* The language of 1998: docs/formats/script.md. */
};

/* The scene as it is now, as a text; comments of the text that was read are not in it. SARSIM_BAD_INPUT where the
 * language cannot say it. */
SARSIM_API sarsim_status sarsim_scene_text(const sarsim_scene* scene, sarsim_language language, sarsim_text** text,
                                           sarsim_problems** problems);

/* Everything that is wrong with the scene or worth knowing about its echoes, as `sarsim check` lists it. SARSIM_BAD_INPUT
 * where it cannot be simulated. */
SARSIM_API sarsim_status sarsim_scene_check(const sarsim_scene* scene, const sarsim_work* work,
                                            sarsim_problems** problems);

/* Number of the objects of a kind: "platform", "target", "cloud", "surface", "radar", "simulation", "geometry". */
SARSIM_API sarsim_status sarsim_scene_count(const sarsim_scene* scene, const char* kind, size_t* count,
                                            sarsim_problems** problems);
/* What precedes the point in the names of its fields: "Radar1", "Target3". */
SARSIM_API sarsim_status sarsim_scene_name(const sarsim_scene* scene, const char* kind, size_t index, sarsim_text** name,
                                           sarsim_problems** problems);

/* The value of a field by the name that `sarsim run --set` has for it: "Radar1.bandwidth", "Target3.position.x", "seed".
 * Numbers have a unit: "50 MHz". SARSIM_BAD_INPUT for a name that means nothing, with the nearest one. */
SARSIM_API sarsim_status sarsim_scene_get(const sarsim_scene* scene, const char* field, sarsim_text** value,
                                          sarsim_problems** problems);
/* Sets it, as --set does: of all objects that the name means ("Target*.rcs"), in any unit ("0.05 GHz"), numbers without a
 * unit in SI units. Where the value is refused the scene is unchanged. What only makes no sense together with other
 * fields, sarsim_scene_check says. */
SARSIM_API sarsim_status sarsim_scene_set(sarsim_scene* scene, const char* field, const char* value,
                                          sarsim_problems** problems);

typedef int sarsim_style;
enum {
  SARSIM_WORDS = 0, /* Lines for people. */
  SARSIM_JSON = 1   /* A JSON object. */
};

/* Explains a field, a choice, a kind of object or a word of format 2, as `sarsim explain` does: "radar.pulse.width".
 * "": what there is. */
SARSIM_API sarsim_status sarsim_explain(const char* word, sarsim_style style, sarsim_text** text,
                                        sarsim_problems** problems);

/* ----------------------------------------------------------------------------------------------------- Recordings */

/* A recording of a scene, checked and with everything decided before its first pulse. Never changes. */
typedef struct sarsim_plan sarsim_plan;

/* Plans recording `number` of a scene, from 1 as the commands count. SARSIM_BAD_INPUT with everything that keeps it from
 * being made; remarks on it where it can be. */
SARSIM_API sarsim_status sarsim_plan_new(const sarsim_scene* scene, size_t number, const sarsim_work* work,
                                         sarsim_plan** plan, sarsim_problems** problems);
SARSIM_API void sarsim_plan_free(sarsim_plan* plan);

/* What a recording is, and what it takes. */
typedef struct sarsim_plan_info {
  size_t struct_size;
  uint64_t rows;             /* Pulses; bursts where range profiles are synthesised. */
  uint64_t columns;          /* Complex samples of a row. */
  double sample_rate_hz;     /* Of the A/D converter. */
  int bits;                  /* Of the A/D converter. */
  double lsb_v;              /* Its least significant bit; 0 where the whole recording is needed to know it. */
  const char* radar;         /* Its name. */
  const char* processing;    /* "raw", "compressed", "range profiles". */
  const char* format;        /* Of the file that the scene asks for: "hdf5". */
  const char* file;          /* The name that the scene gives it. */
  const char* engine;        /* How echoes are added up. */
  const char* engine_reason; /* Why so. */
  double echoes;             /* Targets times pulses. */
  double seconds;            /* Estimate of the time on all cores, good to a factor of two. */
  double memory_bytes;       /* Estimate of the memory while it is made, on all cores. */
  double file_bytes;         /* Of the file that the scene asks for; an estimate for text. */
} sarsim_plan_info;

SARSIM_API sarsim_status sarsim_plan_get_info(const sarsim_plan* plan, sarsim_plan_info* info,
                                              sarsim_problems** problems);

/* What is known of each row or column. */
typedef int sarsim_axis;
enum {
  SARSIM_ROW_TIME_S = 0,       /* When its (first) pulse is sent; a number for each row. */
  SARSIM_ROW_CARRIER_HZ = 1,   /* Carrier of that pulse; a number for each row. */
  SARSIM_COLUMN_RANGE_M = 2,   /* Slant range, one way; a number for each column. */
  SARSIM_ROW_POSITION_M = 3,   /* x, y, z of the radar's platform in world axes then; three numbers for each row. */
  SARSIM_ROW_VELOCITY_MPS = 4, /* Its velocity; three numbers for each row. */
  SARSIM_ROW_ROTATION_RAD = 5  /* Its rotations about x, y and z; three numbers for each row. */
};

/* Copies rows or columns [first, first + count) of an axis to `values`, which has room for count (or 3 count) numbers. */
SARSIM_API sarsim_status sarsim_plan_axis(const sarsim_plan* plan, sarsim_axis axis, uint64_t first, uint64_t count,
                                          double* values, sarsim_problems** problems);

/* Computes rows [first, first + count) of a recording into `samples`, which has room for 2 * count * columns numbers: in
 * volts, without the A/D converter. The same numbers as in the HDF5 and NPY files of `sarsim run`, bit for bit, however
 * the rows are divided among calls and threads. */
SARSIM_API sarsim_status sarsim_record_float(const sarsim_plan* plan, uint64_t first, uint64_t count, float* samples,
                                             const sarsim_work* work, sarsim_problems** problems);
/* The same in double precision, as `sarsim run --double` has it. */
SARSIM_API sarsim_status sarsim_record_double(const sarsim_plan* plan, uint64_t first, uint64_t count, double* samples,
                                              const sarsim_work* work, sarsim_problems** problems);

/* How a recording is stored. NULL in place of it is the same as all zeros. */
typedef struct sarsim_file_options {
  size_t struct_size;
  const char* format; /* "ascii", "csv", "bracket", "binary", "npy", "hdf5". NULL: as the file's ending says, or, where
                         that says nothing, as the scene does. */
  int replace;        /* A file that exists is replaced; 0: it is an error. */
  int counts;         /* Counts of the A/D converter in HDF5 and NPY, in place of volts. */
  int header;         /* A header line in CSV. */
  int doubles;        /* Volts of HDF5 and NPY in double precision. */
} sarsim_file_options;

/* What a file turned out to be. */
typedef struct sarsim_file_report {
  size_t struct_size;
  double seconds;     /* That it took. */
  double bytes;       /* Of the file. */
  double maximum_v;   /* Largest magnitude. */
  double lsb_v;       /* Least significant bit that was used. */
  uint64_t saturated; /* Samples whose I or Q was clipped. */
  uint64_t zero;      /* Samples whose counts are both 0. */
} sarsim_file_report;

/* Makes the file of a recording: the bytes that `sarsim run` writes. It appears when it is complete; stopped or failed,
 * nothing is left behind. `report` may be NULL. */
SARSIM_API sarsim_status sarsim_record_file(const sarsim_plan* plan, const char* path,
                                            const sarsim_file_options* options, const sarsim_work* work,
                                            sarsim_file_report* report, sarsim_problems** problems);

#ifdef __cplusplus
}
#endif

/* Co-simulation unit, FMI 2.0, of a table of friction torques; it needs no other file but table.h.

   table.h has GUID, AXES, COUNTS, NODES, OUTSIDE, SIZE and TABLE. An input is an axis of more than one node; the others
   are constants. Torques lie on straight lines between the nodes of each axis, and beyond the last node they stay. The
   declarations below have the names and the memory layout of the standard, as far as this unit takes part in it. */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "table.h"

#if defined _WIN32
#define EXPORT __declspec(dllexport)
#else
#define EXPORT __attribute__((visibility("default")))
#endif
#define OUTPUTS 4 /* low end of the torque, torque, high end, power: numbered after the axes; then `outside`, an integer */

typedef double fmi2Real;
typedef int fmi2Integer, fmi2Boolean;
typedef const char *fmi2String;
typedef unsigned int fmi2ValueReference;
typedef void *fmi2Component, *fmi2Environment, *fmi2FMUstate;
typedef enum { fmi2OK, fmi2Warning, fmi2Discard, fmi2Error, fmi2Fatal, fmi2Pending } fmi2Status;
typedef struct {
    void (*logger)(fmi2Environment, fmi2String, fmi2Status, fmi2String, fmi2String, ...);
    void *(*allocate)(size_t, size_t);
    void (*release)(void *);
    void (*step_finished)(fmi2Environment, fmi2Status);
    fmi2Environment environment;
} fmi2CallbackFunctions;

typedef struct {
    double time;
    double input[AXES];
} State;

typedef struct {
    State state;
    fmi2CallbackFunctions callbacks;
    char name[128];
} Unit;

static fmi2Status tell(Unit *unit, fmi2Status status, const char *words, double value)
{
    char line[256];
    const char *category = status == fmi2Warning ? "logStatusWarning" : "logStatusError";
    snprintf(line, sizeof line, "%s (got %g)", words, value);
    if (unit->callbacks.logger) /* the line has no %: no arguments follow */
        unit->callbacks.logger(unit->callbacks.environment, unit->name, status, category, line);
    return status;
}

static fmi2Status refuse(Unit *unit, const char *words, double value) { return tell(unit, fmi2Error, words, value); }

/* What the table is read at: an input, or the end of its axis that is nearer. The other direction of rotation mirrors
   the table. */
static double held(int axis, double x)
{
    const double *nodes = NODES;
    double last;
    int i;
    for (i = 0; i < axis; i++)
        nodes += COUNTS[i];
    last = nodes[COUNTS[axis] - 1];
    x = axis == 0 ? fabs(x) : x;
    return x < nodes[0] ? nodes[0] : x > last ? last : x;
}

static int is_outside(int axis, double x) { return held(axis, x) != (axis == 0 ? fabs(x) : x); }

/* The node below x and the share of the one above. */
static int locate(const double *nodes, int count, double x, double *above)
{
    int below = 0;
    *above = 0.0;
    if (count > 1) {
        while (below < count - 2 && nodes[below + 1] <= x)
            below++;
        *above = (x - nodes[below]) / (nodes[below + 1] - nodes[below]);
    }
    return below;
}

/* Low end, torque and high end, N m. */
static void interpolate(const double *input, double *torque)
{
    double above[AXES];
    int below[AXES], axis, part, corner, first = 0;
    for (axis = 0; axis < AXES; axis++) {
        const double *nodes = NODES + first;
        below[axis] = locate(nodes, COUNTS[axis], held(axis, input[axis]), &above[axis]);
        first += COUNTS[axis];
    }
    for (part = 0; part < 3; part++)
        torque[part] = 0.0;
    for (corner = 0; corner < 1 << AXES; corner++) { /* of the cell */
        double weight = 1.0;
        size_t place = 0;
        for (axis = 0; axis < AXES; axis++) {
            int upper = corner >> axis & 1;
            weight *= upper ? above[axis] : 1.0 - above[axis];
            place = place * (size_t)COUNTS[axis] + (size_t)(below[axis] + upper);
        }
        if (weight > 0.0)
            for (part = 0; part < 3; part++)
                torque[part] += weight * TABLE[part][place];
    }
}

static void begin(State *state)
{
    int axis, first = 0;
    state->time = 0.0;
    for (axis = 0; axis < AXES; first += COUNTS[axis++])
        state->input[axis] = NODES[first + COUNTS[axis] / 2];
}

EXPORT fmi2String fmi2GetTypesPlatform(void) { return "default"; }
EXPORT fmi2String fmi2GetVersion(void) { return "2.0"; }

EXPORT fmi2Component fmi2Instantiate(fmi2String name, int kind, fmi2String guid, fmi2String resources,
                                     const fmi2CallbackFunctions *callbacks, fmi2Boolean visible, fmi2Boolean logging)
{
    Unit *unit;
    (void)resources, (void)visible, (void)logging;
    if (kind != 1 || !guid || strcmp(guid, GUID) != 0 || !(unit = calloc(1, sizeof *unit)))
        return NULL; /* 1: co-simulation */
    if (callbacks)
        unit->callbacks = *callbacks;
    if (name)
        strncpy(unit->name, name, sizeof unit->name - 1);
    begin(&unit->state);
    return unit;
}

EXPORT void fmi2FreeInstance(fmi2Component unit) { free(unit); }

EXPORT fmi2Status fmi2SetDebugLogging(fmi2Component unit, fmi2Boolean on, size_t count, const fmi2String *categories)
{
    (void)unit, (void)on, (void)count, (void)categories;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetupExperiment(fmi2Component unit, fmi2Boolean has_tolerance, fmi2Real tolerance,
                                      fmi2Real start, fmi2Boolean has_stop, fmi2Real stop)
{
    (void)has_tolerance, (void)tolerance, (void)has_stop, (void)stop;
    ((Unit *)unit)->state.time = start;
    return fmi2OK;
}

EXPORT fmi2Status fmi2EnterInitializationMode(fmi2Component unit) { return (void)unit, fmi2OK; }
EXPORT fmi2Status fmi2ExitInitializationMode(fmi2Component unit) { return (void)unit, fmi2OK; }
EXPORT fmi2Status fmi2Terminate(fmi2Component unit) { return (void)unit, fmi2OK; }

EXPORT fmi2Status fmi2Reset(fmi2Component unit)
{
    begin(&((Unit *)unit)->state);
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetReal(fmi2Component component, const fmi2ValueReference *which, size_t count, fmi2Real *value)
{
    Unit *unit = component;
    double torque[OUTPUTS];
    size_t i;
    interpolate(unit->state.input, torque);
    torque[3] = torque[1] * fabs(unit->state.input[0]);
    for (i = 0; i < count; i++) {
        if (which[i] >= AXES + OUTPUTS)
            return refuse(unit, "no variable has this reference", which[i]);
        value[i] = which[i] < AXES ? unit->state.input[which[i]] : torque[which[i] - AXES];
    }
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetInteger(fmi2Component component, const fmi2ValueReference *which, size_t count,
                                 fmi2Integer *value)
{
    Unit *unit = component;
    int axis, outside = 0; /* number of the first axis that an input has left, from 1 */
    size_t i;
    for (axis = AXES - 1; axis >= 0; axis--)
        if (is_outside(axis, unit->state.input[axis]))
            outside = axis + 1;
    for (i = 0; i < count; i++) {
        if (which[i] != AXES + OUTPUTS)
            return refuse(unit, "no integer has this reference", which[i]);
        value[i] = outside;
    }
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetReal(fmi2Component component, const fmi2ValueReference *which, size_t count,
                              const fmi2Real *value)
{
    Unit *unit = component;
    fmi2Status status = fmi2OK;
    size_t i;
    for (i = 0; i < count; i++) {
        fmi2ValueReference axis = which[i];
        if (axis >= AXES || COUNTS[axis] == 1)
            return refuse(unit, "only inputs can be set; this reference is of none", axis);
        if (isnan(value[i]))
            return refuse(unit, "an input is no number", value[i]);
        if (is_outside(axis, value[i]) && !is_outside(axis, unit->state.input[axis])) /* once, when it leaves */
            status = tell(unit, fmi2Warning, OUTSIDE[axis], value[i]);
        unit->state.input[axis] = value[i];
    }
    return status;
}

#define NONE(does, kind, type) /* inputs are real, outputs real or an integer */                                     \
    EXPORT fmi2Status fmi2##does##kind(fmi2Component unit, const fmi2ValueReference *which, size_t count, type *value) \
    {                                                                                                                \
        (void)which, (void)value;                                                                                    \
        return count ? refuse(unit, #does " does not fit: this unit has no such " #kind, (double)count) : fmi2OK;     \
    }
NONE(Set, Integer, const fmi2Integer)
NONE(Get, Boolean, fmi2Boolean)
NONE(Set, Boolean, const fmi2Boolean)
NONE(Get, String, fmi2String)
NONE(Set, String, const fmi2String)

EXPORT fmi2Status fmi2GetFMUstate(fmi2Component unit, fmi2FMUstate *state)
{
    if (!*state && !(*state = malloc(sizeof(State))))
        return fmi2Error;
    *(State *)*state = ((Unit *)unit)->state;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SetFMUstate(fmi2Component unit, fmi2FMUstate state)
{
    ((Unit *)unit)->state = *(State *)state;
    return fmi2OK;
}

EXPORT fmi2Status fmi2FreeFMUstate(fmi2Component unit, fmi2FMUstate *state)
{
    (void)unit;
    free(*state);
    *state = NULL;
    return fmi2OK;
}

EXPORT fmi2Status fmi2SerializedFMUstateSize(fmi2Component unit, fmi2FMUstate state, size_t *size)
{
    (void)unit, (void)state;
    *size = sizeof(State);
    return fmi2OK;
}

EXPORT fmi2Status fmi2SerializeFMUstate(fmi2Component unit, fmi2FMUstate state, char *bytes, size_t size)
{
    if (size < sizeof(State))
        return refuse(unit, "the serialized state needs more bytes", (double)size);
    memcpy(bytes, state, sizeof(State));
    return fmi2OK;
}

EXPORT fmi2Status fmi2DeSerializeFMUstate(fmi2Component unit, const char *bytes, size_t size, fmi2FMUstate *state)
{
    if (size != sizeof(State))
        return refuse(unit, "the serialized state has another size", (double)size);
    if (!*state && !(*state = malloc(sizeof(State))))
        return fmi2Error;
    memcpy(*state, bytes, sizeof(State));
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetDirectionalDerivative(fmi2Component unit, const fmi2ValueReference *unknown, size_t unknowns,
                                               const fmi2ValueReference *known, size_t knowns, const fmi2Real *along,
                                               fmi2Real *slope)
{
    (void)unknown, (void)unknowns, (void)known, (void)along, (void)slope;
    return refuse(unit, "this unit gives no derivatives", (double)knowns);
}

EXPORT fmi2Status fmi2SetRealInputDerivatives(fmi2Component unit, const fmi2ValueReference *which, size_t count,
                                              const fmi2Integer *order, const fmi2Real *value)
{
    (void)which, (void)order, (void)value;
    return refuse(unit, "this unit takes no derivatives of inputs", (double)count);
}

EXPORT fmi2Status fmi2GetRealOutputDerivatives(fmi2Component unit, const fmi2ValueReference *which, size_t count,
                                               const fmi2Integer *order, fmi2Real *value)
{
    (void)which, (void)order, (void)value;
    return refuse(unit, "this unit gives no derivatives", (double)count);
}

EXPORT fmi2Status fmi2DoStep(fmi2Component unit, fmi2Real time, fmi2Real step, fmi2Boolean stays)
{
    (void)stays;
    ((Unit *)unit)->state.time = time + step;
    return fmi2OK;
}

EXPORT fmi2Status fmi2CancelStep(fmi2Component unit) { return refuse(unit, "a step is never under way", 0.0); }

EXPORT fmi2Status fmi2GetStatus(fmi2Component unit, int kind, fmi2Status *value)
{
    (void)value;
    return refuse(unit, "no step is ever pending", kind), fmi2Discard;
}

EXPORT fmi2Status fmi2GetRealStatus(fmi2Component unit, int kind, fmi2Real *value)
{
    if (kind != 2) /* 2: the time of the last successful step */
        return fmi2Discard;
    *value = ((Unit *)unit)->state.time;
    return fmi2OK;
}

EXPORT fmi2Status fmi2GetIntegerStatus(fmi2Component unit, int kind, fmi2Integer *value)
{
    return (void)unit, (void)kind, (void)value, fmi2Discard;
}

EXPORT fmi2Status fmi2GetBooleanStatus(fmi2Component unit, int kind, fmi2Boolean *value)
{
    if (kind != 3) /* 3: whether the unit wants to end */
        return fmi2Discard;
    *value = 0;
    return (void)unit, fmi2OK;
}

EXPORT fmi2Status fmi2GetStringStatus(fmi2Component unit, int kind, fmi2String *value)
{
    return (void)unit, (void)kind, (void)value, fmi2Discard;
}

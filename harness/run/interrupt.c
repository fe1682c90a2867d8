#include "interrupt.h"

#include <string.h>

volatile sig_atomic_t interrupted;
static void (*also_called)(void);

static void interrupt(int signal_number)
{
    (void)signal_number;
    interrupted = 1;
    if (also_called)
        also_called();
}

void interrupt_watch(void (*also)(void))
{
    struct sigaction action;
    also_called = also;
    memset(&action, 0, sizeof action);
    action.sa_handler = interrupt;
    action.sa_flags = SA_RESETHAND;
    sigaction(SIGINT, &action, NULL);
    sigaction(SIGTERM, &action, NULL);
}

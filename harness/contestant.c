#include "contestant.h"

#include <errno.h>
#include <fcntl.h>
#include <limits.h>
#include <signal.h>
#include <stdlib.h>
#include <string.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include "../algorithms/core/real.h"

static void become(char *const argv[], int in, int out, int padding)
{
    char *pad = (char *)malloc((size_t)padding + 1);
    if (pad) {
        memset(pad, 'x', (size_t)padding);
        pad[padding] = 0;
        setenv("FATLINE_PADDING", pad, 1);
    }
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    dup2(in, STDIN_FILENO);
    dup2(out, STDOUT_FILENO);
    execv(argv[0], argv);
    _exit(127);
}

const char *contestant_start(struct contestant *c, const char *folder, const char *tolerance,
                             const char *max_steps, const char *file, int padding)
{
    static char why[PATH_MAX + 100];
    char path[PATH_MAX];
    int in[2], out[2];
    memset(c, 0, sizeof *c);
    snprintf(path, sizeof path, "%s/%s/fatline-passes", folder, REAL_NAME);
    char *const argv[] = {path, (char *)tolerance, (char *)max_steps, (char *)file, NULL};
    if (access(path, X_OK)) {
        snprintf(why, sizeof why, "%s: %s", path, strerror(errno));
        return why;
    }
    if (pipe2(in, O_CLOEXEC) || pipe2(out, O_CLOEXEC))
        return "no pipe";
    signal(SIGPIPE, SIG_IGN);
    c->pid = fork();
    if (c->pid == 0)
        become(argv, in[0], out[1], padding);
    close(in[0]);
    close(out[1]);
    c->to = fdopen(in[1], "w");
    c->from = fdopen(out[0], "r");
    return c->pid > 0 && c->to && c->from ? NULL : "cannot be started";
}

const char *contestant_ask(struct contestant *c, const char *request)
{
    fprintf(c->to, "%s\n", request);
    if (fflush(c->to) || getline(&c->line, &c->size, c->from) <= 0)
        return NULL;
    c->line[strcspn(c->line, "\n")] = 0;
    return c->line;
}

void contestant_stop(struct contestant *c)
{
    if (c->to)
        fclose(c->to);
    if (c->from)
        fclose(c->from);
    if (c->pid > 0)
        waitpid(c->pid, NULL, 0);
    free(c->line);
    memset(c, 0, sizeof *c);
}

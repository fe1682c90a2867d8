/* Prints the answers that test_watched compares with its own. */
#include "answers.h"

static struct solver solver;

int main(void)
{
    for (int k = 0; intersectors[k]; k++)
        for (int i = 0; i < ANSWERS_PAIRS; i++) {
            char text[ANSWER_TEXT];
            answers_solve(&solver, intersectors[k], i, NULL, NULL, text);
            solver_clear(&solver);
            puts(text);
        }
    return 0;
}

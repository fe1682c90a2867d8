#!/usr/bin/python3
"""The commands trace, order, cost and lemma, and the verdicts of scripts/claims.py.  Prints TAP."""

import json
import sys

import runner
from runner import CASES, ROOT, Skipped, run_tests

sys.path.insert(0, str(ROOT / "scripts"))
import claims  # noqa: E402


def fatline(*arguments, text=None, status=0):
    return runner.expect(runner.fatline(*arguments, text=text), status)


def rows(*arguments, text):
    return runner.rows(fatline(*arguments, "--rows", text=text))


def generate(*arguments):
    return fatline("generate", *arguments)


def without_answer(lines):
    """The curves and nothing else: no class, no solutions."""
    return "".join(json.dumps({k: v for k, v in json.loads(line).items() if k in ("id", "f", "g")}) + "\n"
                   for line in lines.splitlines())


def test_usage():
    for command in ("trace", "order", "cost", "lemma"):
        assert f"Usage: fatline {command}" in fatline(command, "--help")
        assert fatline(command, "--version") == "fatline 0.1\n"
        fatline(command, "--no-such-option", status=64)
        fatline(command, "-a", "no_such", status=64)
        fatline(command, "no such file", status=2)
        fatline(command, "-q", text="{}\n", status=65)
    assert "geometric mean" in fatline("order", "--help")
    fatline("order", "--protocol", "guess", status=64)


def test_trace_is_the_solve():
    """As many calls as solve takes steps, as many accepted boxes as it has records; widths below 2^-1000 are numbers."""
    lines = generate("nice", "--degree", "3,5", "--count", "3") + generate("tangent_same", "--count", "2")
    solved = [json.loads(line) for line in fatline("solve", "-a", "bezier_clipping,hybrid_clipping_2", "--tolerance",
                                                    "0x1p-30", "-q", text=lines).splitlines()]
    traced = rows("trace", "-q", "--bits", "30", "-a", "bezier_clipping,hybrid_clipping_2", text=lines)
    for answer in solved:
        own = [r for r in traced if (r["id"], r["algorithm"]) == (answer["id"], answer["algorithm"])]
        assert own[-1]["call"] == answer["steps"], answer["id"]
        assert sum(r["event"] == "accepted" for r in own) == len(answer["crossings"]), answer["id"]
        assert [r["step"] for r in own] == list(range(1, len(own) + 1))
    deep = rows("-p", "multi", "trace", "-q", "--bits", "2000", "-a", "hybrid_clipping_3",
                text=generate("nice", "--degree", "5", "--first", "1"))
    last = [r for r in deep if r["event"] == "accepted"][0]
    assert last["log2_t"] < -2000 and last["log2_s"] < -2000 and last["round"] >= 5


def test_trace_counts_rounds():
    """Along a path without splits: a round is over when both widths have fallen."""
    text = generate("nice", "--degree", "5", "--first", "1")
    own = [r for r in rows("-p", "multi", "trace", "-q", "--bits", "1000", "-a", "bezier_clipping", text=text)
           if r["event"] == "shrunk"]
    clip, finished, before = 0, 0, (0, 0)
    for r in own:
        clip += 1
        if r["log2_t"] < before[0] and r["log2_s"] < before[1]:
            finished, before = finished + 1, (r["log2_t"], r["log2_s"])
        assert (r["clip"], r["round"]) == (clip, finished), r


def test_order_without_being_told():
    """The same whether a line says what its solutions are or not."""
    lines = generate("nice", "--degree", "4", "--count", "2") + generate("tangent_same", "--count", "1", "--first", "1")
    names = "bezier_clipping,hybrid_clipping_2"
    told = rows("order", "-q", "-a", names, text=fatline("truth", "-q", text=lines))
    untold = rows("order", "-q", "-a", names, text=without_answer(lines))
    assert len(told) == len(untold) > 0
    for a, b in zip(told, untold):
        assert a["law"] == b["law"] and a["id"] == b["id"]
        if a["per_round"] is not None:
            assert abs(a["per_round"] - b["per_round"]) < 1e-6 * a["per_round"], (a, b)
    laws = {(r["id"].split("-")[0], r["protocol"]): r["law"] for r in untold if r["algorithm"] == "bezier_clipping"}
    assert laws["nice", "boxes"] == "superlinear" and laws["tangent_same", "rounds"] in ("linear", "too_few")


def test_cost_rows():
    text = generate("nice", "--degree", "3", "--count", "1")
    got = rows("cost", "-q", "--to", "16", "-a", "subdivision_oriented", text=text)
    steps = [r["steps"] for r in got if "steps" in r]
    assert [r["log2_eps"] for r in got if "steps" in r] == list(range(-4, -17, -2))
    assert steps == sorted(steps) and got[-1]["law"] == "logarithmic" and got[-1]["b"] > 1
    stopped = rows("cost", "-q", "--to", "16", "--max-steps", "20", "-a", "subdivision_oriented", text=text)
    assert stopped[-1]["law"] == "too_few" and stopped[-2]["outcome"] == "OUT_OF_STEPS"


def test_verdicts():
    def verdict(values, of, claimed=2, within=0.06):
        return claims.judge_values(values, of, claimed, within).verdict
    assert verdict([2.0, 2.01, 1.95], 3) == "holds"
    assert verdict([2.0] * 9 + [3.0], 10) == "holds"
    assert verdict([2.0] * 8 + [3.0] * 2, 10) == "inconclusive"
    assert verdict([2.0, 2.0], 4) == "inconclusive"
    assert verdict([3.0, 2.9], 2) == "fails"
    assert verdict([], 2) == "inconclusive"


def test_claims_are_well_formed():
    known, _, _ = claims.read_claims(claims.algorithms("multi"))
    assert len(known) >= 30
    for claim in known:
        assert claim.kind in claims.JUDGES and claim.verdict in ("holds", "fails", "inconclusive"), claim.id
        assert "{a}" not in claim.command + claim.id + claim.statement, claim.id
        assert "--seed" in claim.command or " roots " in claim.command, claim.id


ORDERS = CASES / "orders.jsonl"
BANDS = {"bezier_clipping": 1, "hybrid_clipping_1": 1, "hybrid_clipping_2_arc": 2, "hybrid_clipping_3_arc": 3}
GAPS = {f"gap_clipping_{k}": k for k in (2, 3, 4, 5)}


def theory(algorithm, mu, cusp):
    """Order per round, 1 where it is linear."""
    if algorithm in GAPS:
        return max(1, (GAPS[algorithm] + 1) / mu)
    return BANDS[algorithm] + 1 if mu == 1 else max(1, (BANDS[algorithm] + 1) / 2) if cusp else 1


def orders_of_others(precision, protocol, within, names):
    """Pairs that this project did not make, without class and solutions: every order that comes out is the one of
    theory, and most come out.  Left out is the centre of the pair with nine solutions, about which both curves are
    symmetric: there the second derivatives vanish and convergence is faster."""
    if not ORDERS.is_file():
        raise Skipped(f"no {ORDERS}")
    lines = ORDERS.read_text()
    what = {c["id"]: c for c in map(json.loads, lines.splitlines())}
    bits = ["--bits", "400"] if precision == "multi" and protocol == "rounds" else []
    got = [r for r in rows("-p", precision, "order", "-q", "--protocol", protocol, *bits, "-a", ",".join(names),
                           text=without_answer(lines)) if (r["id"], r["solution"]) != ("order-nine_3x3", 4)]
    decided = {}
    for r in got:
        cusp = what[r["id"]]["class"] == "degenerate"
        mu = what[r["id"]]["expected"]["mult"][r["solution"]]
        expected = theory(r["algorithm"], mu, cusp)
        of = decided.setdefault((r["algorithm"], mu, cusp), [0, 0])
        of[1] += 1
        if r["law"] in ("too_few", "exact") or (expected > 1 and r["law"] == "stalled"):
            continue
        of[0] += 1
        if expected == 1:
            assert r["law"] in ("linear", "stalled") and (r["per_round"] or 1) < 1.1, r
        else:
            assert r["law"] == "superlinear" and abs(r["per_round"] - expected) <= within * expected, (expected, r)
    assert len({(mu, cusp) for _, mu, cusp in decided}) == 4
    return decided


def test_orders_of_other_peoples_cases_by_rounds():
    decided = orders_of_others("multi", "rounds", 0.03, [*BANDS, *GAPS])
    assert all(2 * a >= b for a, b in decided.values()), decided


def test_orders_of_other_peoples_cases_by_boxes():
    """Rounds from boxes do not fit where a halving comes first, as at contacts without superlinear convergence."""
    decided = orders_of_others("multi", "boxes", 0.03, [*BANDS, "gap_clipping_3"])
    assert all(2 * a >= b for (_, mu, _), (a, b) in decided.items() if mu < 3), decided


def test_orders_of_other_peoples_cases_in_double():
    decided = orders_of_others("double", "boxes", 0.05, ["bezier_clipping", "hybrid_clipping_1", "hybrid_clipping_2_arc",
                                                         "gap_clipping_2"])
    assert all(2 * a >= b for (_, mu, _), (a, b) in decided.items() if mu == 1), decided


if __name__ == "__main__":
    run_tests(globals())

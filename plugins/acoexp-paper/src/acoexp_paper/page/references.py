"""The section of references."""

from __future__ import annotations

from acoexp_paper.page.document import Block, References, Source


def references() -> list[Block]:
    """Return what the report is about, and what its methods are taken from."""
    return [References(_SOURCES)]


_SOURCES = (
    Source(
        "Liu J, Yang J, Liu H, Tian X, Gao M (2017) An improved ant colony algorithm for robot path planning. "
        "Soft Computing 21:5829-5839. The paper that this report is about.",
        "10.1007/s00500-016-2161-7",
    ),
    Source(
        "Luo D, Wu S (2010) Ant colony optimization with potential field heuristic for robot path planning. "
        "Systems Engineering and Electronics 32:1277-1280. ACO-PF, and environments 1 and 2; not available to us."
    ),
    Source(
        "Dorigo M, Maniezzo V, Colorni A (1996) Ant system: optimization by a colony of cooperating agents. IEEE "
        "Transactions on Systems, Man, and Cybernetics B 26:29-41. Standard ACO (Ant-Cycle).",
        "10.1109/3477.484436",
    ),
    Source(
        "Khatib O (1986) Real-time obstacle avoidance for manipulators and mobile robots. International Journal "
        "of Robotics Research 5:90-98. The potential field.",
        "10.1177/027836498600500106",
    ),
    Source(
        "Vargha A, Delaney HD (2000) A critique and improvement of the CL common language effect size "
        "statistics of McGraw and Wong. Journal of Educational and Behavioral Statistics 25:101-132. A12.",
        "10.3102/10769986025002101",
    ),
    Source(
        "DerSimonian R, Laird N (1986) Meta-analysis in clinical trials. Controlled Clinical Trials 7:177-188. "
        "The random-effects model.",
        "10.1016/0197-2456(86)90046-2",
    ),
    Source(
        "Hedges LV (1983) A random effects model for effect sizes. Psychological Bulletin 93:388-395. The spread "
        "between maps.",
        "10.1037/0033-2909.93.2.388",
    ),
    Source(
        "Hartung J, Knapp G (2001) On tests of the overall treatment effect in meta-analysis with normally "
        "distributed responses. Statistics in Medicine 20:1771-1782. The interval of a pooled effect.",
        "10.1002/sim.791",
    ),
    Source(
        "Higgins JPT, Thompson SG, Spiegelhalter DJ (2009) A re-evaluation of random-effects meta-analysis. "
        "Journal of the Royal Statistical Society A 172:137-159. The prediction interval.",
        "10.1111/j.1467-985X.2008.00552.x",
    ),
    Source(
        "Satterthwaite FE (1946) An approximate distribution of estimates of variance components. Biometrics "
        "Bulletin 2:110-114. Whether maps are equal.",
        "10.2307/3002019",
    ),
    Source(
        "Holm S (1979) A simple sequentially rejective multiple test procedure. Scandinavian Journal of "
        "Statistics 6:65-70. The correction for many tests."
    ),
    Source(
        "Wilson EB (1927) Probable inference, the law of succession, and statistical inference. Journal of the "
        "American Statistical Association 22:209-212. Intervals of shares.",
        "10.1080/01621459.1927.10502953",
    ),
    Source(
        "Auger A, Hansen N (2005) Performance evaluation of an advanced local search evolutionary algorithm. IEEE "
        "Congress on Evolutionary Computation, 1777-1784. The expected running time.",
        "10.1109/CEC.2005.1554903",
    ),
)

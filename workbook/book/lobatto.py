"""The nine points of an interval of a cycle, and what they count in a mean (rule of Gauss and Lobatto)."""

SHARES = (0.0, 0.0501210022942699, 0.161406860244631, 0.318441268086911, 0.5,
          0.681558731913089, 0.838593139755369, 0.94987899770573, 1.0)  # fmt: skip
WEIGHTS = (0.0138888888888889, 0.0827476807804028, 0.137269356250081, 0.173214255486523, 0.185759637188209,
           0.173214255486523, 0.137269356250081, 0.0827476807804028, 0.0138888888888889)  # fmt: skip
"""of points of an interval, and of what they count. Source: Abramowitz and Stegun, 25.4.32"""

package nephele.engine.atmosphere;

/** Weights of four neighbouring nodes for cubic interpolation between the middle two (Catmull and Rom 1974). */
final class CubicWeights {
    private CubicWeights() {}

    /** Returns the index of the node before a place; it has another one behind it. */
    static int cell(double place, int nodes) {
        return Math.max(0, Math.min(nodes - 2, (int) place));
    }

    /** Puts the weights for a place 0–1 between two nodes that have neighbours on both sides. */
    static void put(double place, double[] weights) {
        double rest = 1 - place;
        weights[0] = -0.5 * place * rest * rest;
        weights[1] = rest * (1 + place - 1.5 * place * place);
        weights[2] = place * (1 + rest - 1.5 * rest * rest);
        weights[3] = -0.5 * rest * place * place;
    }

    /** Puts the weights in a row of nodes; a missing neighbour lies on the parabola through the other three. */
    static void put(double place, int cell, int nodes, double[] weights) {
        put(place, weights);
        if (cell == 0) {
            weights[1] += 3 * weights[0];
            weights[2] -= 3 * weights[0];
            weights[3] += weights[0];
            weights[0] = 0;
        } else if (cell == nodes - 2) {
            weights[2] += 3 * weights[3];
            weights[1] -= 3 * weights[3];
            weights[0] += weights[3];
            weights[3] = 0;
        }
    }
}

package nephele.app.corpus;

import static nephele.app.corpus.OddLevel.box;
import static nephele.app.corpus.OddLevel.many;
import static nephele.app.corpus.OddLevel.solids;
import static nephele.app.corpus.OddLevel.vector;

import java.util.List;

/**
 * Levels of thousands of solids that touch or overlap: enough to distinguish near-linear work from quadratic work. Ten
 * thousand are in the tests of neighbour search, depenetration and shadows.
 */
final class Crowds {
    static final List<OddLevel> ALL = List.of(
            solids("3000 identical boxes", many(3_000, i -> box("b" + i, "[2, 0.5, 0]", "[1, 1, 1]"))),
            solids(
                    "2000 boxes 1 mm apart",
                    many(
                            2_000,
                            i -> box("b" + i, vector((811 + i % 100) / 1e3, (500 + i / 100) / 1e3, 4), "[1, 1, 1]"))),
            solids(
                    "2500 boxes with gaps of 1 mm around the player's knees",
                    many(2_500, i -> box("b" + i, vector(gap(i % 50), 0.5, 4 + gap(i / 50)), "[0.01, 0.01, 0.01]"))));

    private Crowds() {}

    private static double gap(int index) {
        return 0.011 * (index - 24.5);
    }
}

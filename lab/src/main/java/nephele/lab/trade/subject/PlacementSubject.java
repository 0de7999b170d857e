package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.portal.Obstacles;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.Placement;
import nephele.engine.portal.placement.PlacementResult;
import nephele.lab.placement.RandomWall;
import nephele.lab.placement.RectangleQuestion;
import nephele.lab.placement.WallShot;
import nephele.lab.trade.CostMetric;
import nephele.lab.trade.ErrorMetric;
import nephele.lab.trade.Experiment;
import nephele.lab.trade.Judgement;
import nephele.lab.trade.Setting;
import nephele.lab.trade.Trade;

/** The test whether a portal fits at the aimed place: the student report's four lines against the exact search. */
public final class PlacementSubject implements Experiment {
    private static final int QUESTIONS = 6_000;
    private static final int TIMED = 500;

    public static final Trade TRADE = new Trade(
            "placement",
            new Trade.Text(
                    "Where a portal fits",
                    "Four lines from the aimed point to the rectangle's corners miss holes and notches between them."
                            + " The exact test knows the whole outline; in the game it also moves the portal to the"
                            + " nearest place where it fits. Of the four lines the ray that finds the wall is not"
                            + " counted.",
                    "areas clipped by brute force, on made-up walls of triangles with holes"),
            List.of(),
            List.of(
                    new Setting("fourLines", "the student report's way"),
                    new Setting("exact", "the game's, without moving the portal")),
            1,
            new ErrorMetric("wrong yes and wrong no", "%", 0.05, 0.1),
            List.of("of its yes, wrong, %", "of what fits, refused, %"),
            new CostMetric("CPU a placement", "µs", 1e3, TIMED, CostMetric.Clock.THREAD),
            null,
            site -> new PlacementSubject());

    private final List<RectangleQuestion> questions = new ArrayList<>();
    /** For each question the exact search, at the aimed place only. */
    private final List<Placement> exact = new ArrayList<>();

    /** Uses the result, so that the compiler cannot eliminate the timed code. */
    private int accepted;

    /** Asks on walls without columns, because the four lines consider only triangles. */
    private PlacementSubject() {
        for (long seed = 0; questions.size() < QUESTIONS; seed++) {
            var random = new SplittableRandom(seed);
            WallShot shot = new WallShot(RandomWall.of(random), random);
            if (shot.wall.soup() != null && shot.wall.columns().isEmpty()) {
                RectangleQuestion asked = RectangleQuestion.of(shot);
                questions.add(asked);
                Gun fixed = new Gun(asked.rectangle(), shot.gun.rangeMetres(), 0);
                exact.add(new Placement(shot.wall.surfaces(), fixed));
            }
        }
    }

    @Override
    public Judgement judge(int setting) {
        int fitting = 0;
        int refused = 0;
        int yes = 0;
        int wrongYes = 0;
        for (int question = 0; question < questions.size(); question++) {
            boolean fits = questions.get(question).fits();
            boolean answer = answer(setting, question);
            fitting += fits ? 1 : 0;
            refused += fits && !answer ? 1 : 0;
            yes += answer ? 1 : 0;
            wrongYes += answer && !fits ? 1 : 0;
        }
        double ofYes = 100.0 * wrongYes / Math.max(1, yes);
        double ofFitting = 100.0 * refused / fitting;
        return Judgement.of(ofYes + ofFitting, ofYes, ofFitting);
    }

    private boolean answer(int setting, int question) {
        RectangleQuestion asked = questions.get(question);
        return setting == 0
                ? asked.byFourLines()
                : exact.get(question).place("shot", asked.shot().aim, List.of(), Obstacles.NONE)
                        instanceof PlacementResult.Fits;
    }

    @Override
    public void run(int setting) {
        for (int question = 0; question < TIMED; question++) {
            accepted += answer(setting, question) ? 1 : 0;
        }
    }
}

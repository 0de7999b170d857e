package nephele.workshop.prove.portals;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.portal.placement.PlacementResult;
import nephele.lab.placement.RandomWall;
import nephele.lab.placement.RectangleQuestion;
import nephele.lab.placement.WallShot;
import nephele.workshop.prove.proof.Claim;
import nephele.workshop.prove.proof.Figure;
import nephele.workshop.prove.proof.Proof;
import nephele.workshop.prove.proof.ProofResult;

/** Shoots portals at random walls and searches for better answers by clipping areas. */
public final class PlacementProof implements Proof {
    @Override
    public Claim claim() {
        return new Claim(
                "placement",
                "On any wall a portal lies wholly on it, at the nearest place where it can, or is refused because there"
                        + " is none; the reason given is the right one.",
                "shots",
                100_000,
                10_000);
    }

    @Override
    public ProofResult run(long from, long count, Progress progress) {
        List<String> failures = new ArrayList<>();
        FourLinesTally fourLines = new FourLinesTally();
        long[] nanoseconds = new long[(int) count];
        ThreadMXBean clock = ManagementFactory.getThreadMXBean();
        int placed = 0;
        int slid = 0;
        for (long unit = from; unit < from + count; unit++) {
            var random = new SplittableRandom(unit);
            WallShot shot = new WallShot(RandomWall.of(random), random);
            long start = clock.getCurrentThreadCpuTime();
            PlacementResult answer = shot.placed(shot.gun, shot.others);
            nanoseconds[(int) (unit - from)] = clock.getCurrentThreadCpuTime() - start;
            String objection = new PlacementChecker(shot, random).objection(answer);
            if (objection != null) {
                failures.add("shot " + unit + " " + objection);
            }
            fourLines.judge(shot);
            placed += answer instanceof PlacementResult.Fits ? 1 : 0;
            slid += answer instanceof PlacementResult.Fits fits && fits.slideMetres() > 0 ? 1 : 0;
            progress.unitsDone(unit + 1 - from);
        }
        Arrays.sort(nanoseconds);
        List<Figure> figures = new ArrayList<>(List.of(
                Figure.sum("portals", placed, ""),
                Figure.sum("of them slid", slid, ""),
                Figure.greatest("median query of a batch", nanoseconds[nanoseconds.length / 2] / 1e6, "ms"),
                Figure.greatest(
                        "999 of 1000 queries of a batch", nanoseconds[nanoseconds.length * 999 / 1000] / 1e6, "ms"),
                Figure.greatest(
                        "longest query, compilation and collection included",
                        nanoseconds[nanoseconds.length - 1] / 1e6,
                        "ms")));
        figures.addAll(fourLines.figures());
        return ProofResult.of(count, failures, figures);
    }

    /** Counts the wrong answers of the student report's four lines, for its rectangle at the aimed place. */
    private static final class FourLinesTally {
        private int asked;
        private int accepted;
        private int wronglyAccepted;
        private int wronglyRefused;

        void judge(WallShot shot) {
            if (shot.wall.soup() == null) {
                return;
            }
            RectangleQuestion question = RectangleQuestion.of(shot);
            boolean accepts = question.byFourLines();
            asked++;
            accepted += accepts ? 1 : 0;
            wronglyAccepted += accepts && !question.fits() ? 1 : 0;
            wronglyRefused += question.fits() && !accepts ? 1 : 0;
        }

        List<Figure> figures() {
            return List.of(
                    Figure.sum("rectangles shown to the four lines", asked, ""),
                    Figure.sum("accepted by them", accepted, ""),
                    Figure.sum("wrongly accepted", wronglyAccepted, ""),
                    Figure.sum("wrongly refused", wronglyRefused, ""));
        }
    }
}

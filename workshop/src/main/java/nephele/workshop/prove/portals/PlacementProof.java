package nephele.workshop.prove.portals;

import java.lang.management.ManagementFactory;
import java.lang.management.ThreadMXBean;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import nephele.engine.portal.Portal;
import nephele.engine.portal.placement.Gun;
import nephele.engine.portal.placement.PlacementResult;
import nephele.engine.portal.placement.PlacementResult.Refusal;
import nephele.lab.placement.ClippedAreas;
import nephele.lab.placement.RandomWall;
import nephele.lab.placement.RectangleQuestion;
import nephele.lab.placement.WallPlace;
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
        ProofResult fourLines = ProofResult.NOTHING;
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
            String objection = new Checker(shot, random).objection(answer);
            if (objection != null) {
                failures.add("shot " + unit + " " + objection);
            }
            fourLines = fourLines.and(fourLines(shot));
            placed += answer instanceof PlacementResult.Fits ? 1 : 0;
            slid += answer instanceof PlacementResult.Fits fits && fits.slideMetres() > 0 ? 1 : 0;
            progress.unitsDone(unit + 1 - from);
        }
        Arrays.sort(nanoseconds);
        List<Figure> figures = List.of(
                Figure.sum("portals", placed, ""),
                Figure.sum("of them slid", slid, ""),
                Figure.greatest("median query of a batch", nanoseconds[nanoseconds.length / 2] / 1e6, "ms"),
                Figure.greatest(
                        "999 of 1000 queries of a batch", nanoseconds[nanoseconds.length * 999 / 1000] / 1e6, "ms"),
                Figure.greatest(
                        "longest query, compilation and collection included",
                        nanoseconds[nanoseconds.length - 1] / 1e6,
                        "ms"));
        return ProofResult.of(count, failures, figures).and(fourLines);
    }

    /** Counts the wrong answers of the student report's four lines, for its rectangle at the aimed place. */
    private static ProofResult fourLines(WallShot shot) {
        boolean isAsked = shot.wall.soup() != null;
        RectangleQuestion question = isAsked ? RectangleQuestion.of(shot) : null;
        boolean accepts = isAsked && question.byFourLines();
        boolean fits = isAsked && question.fits();
        return ProofResult.of(
                0,
                List.of(),
                Figure.sum("rectangles shown to the four lines", isAsked ? 1 : 0, ""),
                Figure.sum("accepted by them", accepts ? 1 : 0, ""),
                Figure.sum("wrongly accepted", accepts && !fits ? 1 : 0, ""),
                Figure.sum("wrongly refused", fits && !accepts ? 1 : 0, ""));
    }

    /** Searches for a better answer to a shot than the given one. */
    private static final class Checker {
        /** The tolerance in metres within which a place counts neither as whole nor as not whole. */
        private static final double MARGIN_METRES = 1e-6;

        private static final int SCATTERED = 300;
        private static final int CRITICAL = 200;
        private static final int CLOSE = 60;

        private final WallShot shot;
        private final SplittableRandom random;
        private final ClippedAreas alone;
        private final ClippedAreas beside;
        private final double[] surely;

        Checker(WallShot shot, SplittableRandom random) {
            this.shot = shot;
            this.random = random;
            alone = new ClippedAreas(shot.pieces, shot.inTheWay(List.of()));
            beside = new ClippedAreas(shot.pieces, shot.inTheWay(shot.others));
            surely = shot.shape(MARGIN_METRES);
        }

        /** Returns an error of the answer in words; {@code null} if there is none. */
        String objection(PlacementResult placed) {
            if (placed instanceof PlacementResult.Fits fits) {
                return objection(fits, beside, shot.gun.slideMetres());
            }
            Refusal reason = ((PlacementResult.Refused) placed).reason();
            return switch (reason) {
                case NOT_PORTALABLE -> isOnColumn() ? null : "portals are allowed there";
                case OVERLAPS_OTHER -> overlapsOther();
                case EDGE -> edge();
                case TOO_SMALL -> nearer(alone, 20, null) == null ? null : "there is a place";
                case NOTHING_HIT, OUT_OF_RANGE, MOVING_SURFACE, NOT_FLAT, OCCUPIED ->
                    "the wall is in range and nobody near: " + reason;
            };
        }

        private boolean isOnColumn() {
            return shot.wall.columns().stream().anyMatch(column -> ClippedAreas.contains(column, shot.x, shot.y));
        }

        private String objection(PlacementResult.Fits fits, ClippedAreas areas, double slide) {
            Portal portal = fits.portal();
            WallPlace place = shot.wall.place();
            double x = place.x(portal.centre());
            double y = place.y(portal.centre());
            double away = length(x - shot.x, y - shot.y);
            Vec3 up = place.expectedUp(shot.aim.view());
            if (Math.abs(place.height(portal.centre())) > 1e-8
                    || Directions.angle(portal.normal(), place.normal()) > 1e-8
                    || Directions.angle(portal.frame().up(), up) > 1e-7) {
                return "stands wrong: " + portal;
            } else if (Math.abs(away - fits.slideMetres()) > 1e-7 || away > slide + 1e-9) {
                return "is " + away + " m from the aim, not " + fits.slideMetres();
            } else if (!areas.isWhole(shot.shape(-MARGIN_METRES), x, y)) {
                return "is not whole at " + x + ", " + y;
            }
            String better = nearer(areas, away, new double[] {x, y});
            return better == null ? null : "is " + away + " m away, but " + better;
        }

        private String overlapsOther() {
            String place = nearer(beside, shot.gun.slideMetres(), null);
            if (place != null) {
                return "overlaps nothing: " + place;
            }
            PlacementResult without = shot.placed(shot.gun, List.of());
            return without instanceof PlacementResult.Fits fits
                    ? objection(fits, alone, shot.gun.slideMetres())
                    : "is refused without the other as well";
        }

        private String edge() {
            String place = nearer(beside, shot.gun.slideMetres(), null);
            if (place != null) {
                return "a place is near: " + place;
            }
            Gun sliding = new Gun(shot.gun.aperture(), shot.gun.rangeMetres(), 1000);
            PlacementResult anywhere = shot.placed(sliding, List.of());
            return anywhere instanceof PlacementResult.Fits fits
                    ? objection(fits, alone, 1000)
                    : "there is no place at all";
        }

        /**
         * Returns a whole place that is nearer, in words; {@code null} if none is found. It tries scattered places, places
         * where a corner of the aperture touches a corner of the surface, and places close to the given one.
         */
        private String nearer(ClippedAreas areas, double metres, double[] given) {
            for (int i = 0; i < SCATTERED + CRITICAL + CLOSE; i++) {
                double[] at = i < SCATTERED ? scattered(metres) : i < SCATTERED + CRITICAL ? critical() : close(given);
                if (at != null
                        && length(at[0] - shot.x, at[1] - shot.y) < metres - MARGIN_METRES
                        && areas.isWhole(surely, at[0], at[1])) {
                    return "a place is at " + at[0] + ", " + at[1];
                }
            }
            return null;
        }

        private double[] scattered(double metres) {
            double angle = random.nextDouble(-Math.PI, Math.PI);
            double radius = metres * Math.sqrt(random.nextDouble());
            return new double[] {shot.x + radius * Math.cos(angle), shot.y + radius * Math.sin(angle)};
        }

        private double[] critical() {
            return new double[] {touching(0), touching(1)};
        }

        private double touching(int axis) {
            if (random.nextInt(4) == 0) {
                return axis == 0 ? shot.x : shot.y;
            }
            List<double[]> pieces = shot.pieces;
            double[] piece = pieces.get(random.nextInt(pieces.size()));
            double[] shape = surely;
            return piece[2 * random.nextInt(piece.length / 2) + axis]
                    - shape[2 * random.nextInt(shape.length / 2) + axis]
                    + (random.nextInt(3) - 1) * 2 * MARGIN_METRES;
        }

        private double[] close(double[] given) {
            if (given == null) {
                return null;
            }
            double angle = random.nextDouble(-Math.PI, Math.PI);
            double radius = Math.exp(random.nextDouble(-11, 0));
            return new double[] {given[0] + radius * Math.cos(angle), given[1] + radius * Math.sin(angle)};
        }

        private static double length(double dx, double dy) {
            return Math.sqrt(dx * dx + dy * dy);
        }
    }
}

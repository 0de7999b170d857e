package nephele.engine.choice;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.level.Cloud;
import nephele.engine.level.CloudTechnique;

/**
 * The choice of the technique of a cloud: the cheapest one whose error is allowed (of those that cost the same the least wrong one), or the least wrong one. Where the eye can be anywhere it is the
 * volume, which shows every cloud from everywhere.
 *
 * @param inside whether its error is allowed
 * @param chosen the technique with its error and cost
 * @param runnerUp the one that is chosen without it; {@code null} for none
 */
public record TechniqueChoice(CloudSituation situation, boolean inside, Candidate chosen, Candidate runnerUp) {
    /** What draws a cloud of a form that the table does not have. */
    static final Candidate UNMEASURED = new Candidate(CloudTechnique.VOLUME, 0, 0, 0);

    /** The techniques through which an eye can pass. */
    private static final Set<CloudTechnique> CROSSABLE = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.VOLUME);

    /** Costs that differ by less count as the same: they were measured no better, and then the least wrong technique is chosen. */
    private static final double SAME_COST = 1.1;

    private static final Set<CloudTechnique> OF_BALLS = EnumSet.of(CloudTechnique.PARTICLES, CloudTechnique.BILLBOARD);

    /** Pixels of a radian in the middle of a picture 1,280 pixels wide, with the player's field of view. */
    private static final double PIXELS_PER_RADIAN = 360 / Math.tan(Math.toRadians(30));

    /**
     * A technique that can show a cloud.
     *
     * @param errorPixels by which it displaces what is seen
     * @param errorPercent root mean square of its radiance's error
     */
    public record Candidate(CloudTechnique technique, double errorPixels, double errorPercent, double cost) {
        boolean isAllowed(Cloud.Tolerance by) {
            return errorPixels <= by.maxErrorPixels() && errorPercent <= by.maxErrorPercent();
        }

        /** Returns its error as a multiple of the allowed one. */
        double excess(Cloud.Tolerance by) {
            return Math.max(excess(errorPixels, by.maxErrorPixels()), excess(errorPercent, by.maxErrorPercent()));
        }

        private static double excess(double error, double allowed) {
            return error == 0 ? 0 : error / allowed;
        }
    }

    /** Chooses the technique of a cloud. */
    public static TechniqueChoice of(Cloud cloud, CloudSituation situation, ErrorTable table) {
        List<Candidate> candidates = candidates(cloud, situation, table);
        Candidate best = best(candidates, cloud.tolerance());
        List<Candidate> others = new ArrayList<>(candidates);
        others.remove(best);
        Candidate second = others.isEmpty() ? null : best(others, cloud.tolerance());
        return new TechniqueChoice(situation, best.isAllowed(cloud.tolerance()), best, second);
    }

    private static List<Candidate> candidates(Cloud cloud, CloudSituation situation, ErrorTable table) {
        List<Candidate> candidates = new ArrayList<>();
        for (CloudTechnique technique : CloudTechnique.values()) {
            if (technique == CloudTechnique.AUTO || !canShow(technique, cloud, situation)) {
                continue;
            }
            table.errorPercent(technique, situation)
                    .ifPresent(percent -> candidates.add(new Candidate(
                            technique,
                            errorPixels(technique, situation),
                            percent,
                            table.cost(technique, situation).orElseThrow())));
        }
        return candidates.isEmpty() ? List.of(UNMEASURED) : candidates;
    }

    /** Returns whether an eye can pass through clouds that a technique draws. */
    public static boolean isCrossable(CloudTechnique technique) {
        return CROSSABLE.contains(technique);
    }

    private static boolean canShow(CloudTechnique technique, Cloud cloud, CloudSituation situation) {
        boolean isLayer = cloud.extent() instanceof Cloud.Extent.Layer;
        boolean isCrossed = situation.distanceMetres() <= 0;
        boolean isPastBaking = technique == CloudTechnique.SKYBOX && situation.moves();
        boolean isAnywhere = Double.isInfinite(situation.travelMetres());
        if (isAnywhere) {
            return technique == CloudTechnique.VOLUME;
        }
        return !(isLayer && OF_BALLS.contains(technique)) && !(isCrossed && !isCrossable(technique)) && !isPastBaking;
    }

    /**
     * Returns by how many pixels a technique displaces a cloud while the eye travels: a skybox by the whole parallax, a
     * sheet by that of the near side against the middle.
     */
    public static double errorPixels(CloudTechnique technique, CloudSituation at) {
        double whole = Math.atan2(at.travelMetres(), at.distanceMetres());
        return PIXELS_PER_RADIAN
                * switch (technique) {
                    case SKYBOX -> whole;
                    case SKYPLANE, PROCEDURAL ->
                        whole - Math.atan2(at.travelMetres(), at.distanceMetres() + at.behindMetres());
                    default -> 0;
                };
    }

    private static Candidate best(List<Candidate> candidates, Cloud.Tolerance tolerance) {
        double cheapest = candidates.stream()
                .filter(candidate -> candidate.isAllowed(tolerance))
                .mapToDouble(Candidate::cost)
                .min()
                .orElse(Double.POSITIVE_INFINITY);
        return candidates.stream()
                .filter(candidate -> Double.isInfinite(cheapest)
                        || candidate.isAllowed(tolerance) && candidate.cost() <= SAME_COST * cheapest)
                .min(Comparator.comparingDouble(candidate -> candidate.excess(tolerance)))
                .orElseThrow();
    }
}

package nephele.engine.cloud.drawn;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.CloudTechnique;

/**
 * The change from the techniques that drew the clouds of a level to others. Each stage draws the clouds over the stages
 * before it with a fraction of their optical depth. The fractions add up to 1, so that what passes through the clouds stays the
 * same. Immutable.
 *
 * @param target the stage that remains; those before it disappear under it, those after it uncover it
 */
public record TechniqueFade(List<Stage> stages, int target) {
    /** Duration of a change. */
    public static final double SECONDS = 1;

    /**
     * Growth of a stage's fraction f. A pixel shows 1 − exp(−τ f) of it over the others. With a fraction that grows
     * exponentially, thin and thick parts of a cloud change equally fast, each in its turn, up to τ = exp(STEEPNESS).
     */
    private static final double STEEPNESS = 5;

    /**
     * The techniques of all clouds.
     *
     * @param progress 0 for a stage that shows nothing yet, 1 for one that hides those before it
     */
    public record Stage(List<CloudTechnique> techniques, double progress) {
        private Stage moved(double by) {
            return new Stage(techniques, Math.max(0, Math.min(1, progress + by)));
        }

        /** Returns the fraction of the optical depth that this stage takes from the stages before it. */
        private double cover() {
            return Math.expm1(STEEPNESS * progress) / Math.expm1(STEEPNESS);
        }
    }

    public TechniqueFade {
        stages = List.copyOf(stages);
    }

    /** Returns techniques that draw alone. */
    public static TechniqueFade complete(List<CloudTechnique> techniques) {
        return new TechniqueFade(List.of(new Stage(List.copyOf(techniques), 1)), 0);
    }

    /** Returns the beginning of a change to other techniques; one that is under way turns back if they are still drawn. */
    public TechniqueFade towards(List<CloudTechnique> techniques) {
        for (int i = 0; i < stages.size(); i++) {
            if (stages.get(i).techniques.equals(techniques)) {
                return new TechniqueFade(stages, i);
            }
        }
        List<Stage> more = new ArrayList<>(stages);
        more.add(new Stage(List.copyOf(techniques), 0));
        return new TechniqueFade(more, stages.size());
    }

    /** Returns the change after some time, without the stages that show nothing any more. */
    public TechniqueFade after(double seconds) {
        double step = seconds / SECONDS;
        List<Stage> moved = new ArrayList<>();
        for (int i = 0; i < stages.size(); i++) {
            moved.add(i == 0 ? stages.get(0) : stages.get(i).moved(i <= target ? step : -step));
        }
        int lowest = target;
        while (lowest > 0 && moved.get(lowest).progress < 1) {
            lowest--;
        }
        int end = moved.size();
        while (end > target + 1 && moved.get(end - 1).progress == 0) {
            end--;
        }
        List<Stage> left = new ArrayList<>(moved.subList(lowest, end));
        left.set(0, new Stage(left.get(0).techniques, 1));
        return new TechniqueFade(left, target - lowest);
    }

    /** Returns true if the techniques of one stage draw alone. */
    public boolean isComplete() {
        return stages.size() == 1;
    }

    /** Returns the techniques that remain. */
    public List<CloudTechnique> techniques() {
        return stages.get(target).techniques;
    }

    /** Returns the fraction of the clouds' optical depth that a stage draws. */
    public double fraction(int stage) {
        double fraction = stages.get(stage).cover();
        for (int i = stage + 1; i < stages.size(); i++) {
            fraction *= 1 - stages.get(i).cover();
        }
        return fraction;
    }

    /** Returns the fraction of the stage with these techniques, 0 if there is none. */
    public double fraction(List<CloudTechnique> techniques) {
        for (int i = 0; i < stages.size(); i++) {
            if (stages.get(i).techniques.equals(techniques)) {
                return fraction(i);
            }
        }
        return 0;
    }
}

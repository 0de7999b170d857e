package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.ModelPlacement;
import nephele.engine.level.placed.MeshAssets;
import nephele.engine.math.Chance;
import nephele.engine.math.Vec3;
import nephele.engine.model.bound.Bound;
import nephele.engine.model.bound.BoundedModel;
import nephele.engine.model.bound.Pose;
import nephele.host.named.LevelName;
import nephele.host.named.OpenedLevel;

/** Pairs of the models of the sample {@code models}, turned at random and so far apart that their spheres nearly touch or overlap. */
public final class ModelPairs {
    private static final String SAMPLE = "levels/samples/models.json";
    /** Distance of the middles as a fraction of the sum of the radii. */
    private static final double NEAREST = 0.15;

    private static final double FARTHEST = 1.1;
    private static final int FIRST = 0;
    private static final int SECOND = 1;
    private static final int DISTANCE = 2;
    private static final int TURN = 3;
    private static final int OTHER_TURN = 6;
    private static final int DIRECTION = 9;

    private final List<BoundedModel> models = new ArrayList<>();

    /** A model beside another one. */
    public record Pair(BoundedModel a, Pose atA, BoundedModel b, Pose atB) {
        /** Returns true if the bounds of both touch. */
        public boolean touch(Bound bound) {
            return bound.touch(a, atA, b, atB);
        }

        /** Returns both models in words. */
        public String names() {
            return a.name() + " and " + b.name();
        }
    }

    /** Reads the models of the sample. */
    public ModelPairs() {
        OpenedLevel opened = new LevelName(SAMPLE).open();
        var meshes = new MeshAssets(opened.assets());
        opened.level().models().stream()
                .map(ModelPlacement::file)
                .distinct()
                .forEach(file -> models.add(BoundedModel.of(file, meshes.mesh(file))));
    }

    /** Returns the pair of a number; the same number always gives the same pair. */
    public Pair pair(long number) {
        long dice = Chance.dice(1, number);
        BoundedModel a = models.get((int) (models.size() * Chance.unit(dice, FIRST)));
        BoundedModel b = models.get((int) (models.size() * Chance.unit(dice, SECOND)));
        double fraction = NEAREST + (FARTHEST - NEAREST) * Chance.unit(dice, DISTANCE);
        double distance = fraction * (a.sphere().radius() + b.sphere().radius());
        Pose atA = Pose.random(dice, TURN, Vec3.ZERO);
        Pose turned = Pose.random(dice, OTHER_TURN, Vec3.ZERO);
        Vec3 middle = a.middle(atA)
                .addScaled(distance, Pose.random(dice, DIRECTION, Vec3.ZERO).x());
        return new Pair(
                a, atA, b, turned.movedTo(middle.minus(turned.moved(b.sphere().centre()))));
    }
}

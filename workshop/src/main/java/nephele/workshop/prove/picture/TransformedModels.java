package nephele.workshop.prove.picture;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.scenes.xml.Dialect;
import nephele.scenes.xml.XmlGroup;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlLight;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlModel.Colours;
import nephele.scenes.xml.XmlScene;

/**
 * Scenes by number: models in groups up to four deep, moved, rotated, scaled along the axes, mirrored and animated,
 * around a random view. The number determines all of it.
 */
final class TransformedModels {
    static final int MODELS = 25;

    private static final List<String> FILES = List.of(
            "box_2_2.3d",
            "sphere_1_12_8.3d",
            "cone_1_3_9_4.3d",
            "plane_2_3.3d",
            "cylinder_0.5_2_9.3d",
            "torus_1_0.3_12_8.3d",
            "bezier_3.3d");
    private static final Vec3 GREY = new Vec3(0.2, 0.2, 0.2);

    private final SplittableRandom random;

    TransformedModels(long number) {
        random = new SplittableRandom(number);
    }

    XmlScene scene() {
        List<XmlGroup> groups = new ArrayList<>();
        for (int i = 0; i < MODELS; i++) {
            groups.add(group(random.nextInt(4)));
        }
        var root = new XmlGroup(1, List.of(), List.of(), List.of(), groups);
        var eye = new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, 1), new Vec3(0, 1, 0), 60, 1, 1000);
        List<XmlLight> lights = List.of(new XmlLight.Directional(new Vec3(1, 2, 3)));
        return new XmlScene(Dialect.WORLD, new XmlScene.Window(64, 64), eye, lights, root, List.of());
    }

    private XmlGroup group(int groupsBelow) {
        if (groupsBelow > 0) {
            return new XmlGroup(1, steps(), List.of(), List.of(), List.of(group(groupsBelow - 1)));
        }
        var colours = new Colours(point(1), GREY, Vec3.ZERO, Vec3.ZERO, 0);
        var model = new XmlModel(1, FILES.get(random.nextInt(FILES.size())), null, colours);
        return new XmlGroup(1, steps(), List.of(), List.of(model), List.of());
    }

    private List<Step> steps() {
        List<Step> steps = new ArrayList<>();
        int count = 1 + random.nextInt(3);
        for (int i = 0; i < count; i++) {
            steps.add(step());
        }
        return steps;
    }

    private Step step() {
        return switch (random.nextInt(7)) {
            case 0, 1, 2 -> new Step.Translate(point(8));
            case 3 -> new Step.Rotate(point(1), 720 * random.nextDouble() - 360);
            case 4 -> new Step.Spin(point(1), 1 + 9 * random.nextDouble());
            case 5 -> new Step.Scale(new Vec3(factor(), factor(), factor()));
            default ->
                new Step.Follow(
                        1 + 9 * random.nextDouble(),
                        List.of(point(6), point(6), point(6), point(6)),
                        random.nextBoolean());
        };
    }

    /** Returns a scale, negative in half of the cases and sometimes nearly zero. */
    private double factor() {
        double size = random.nextInt(12) == 0 ? 0.01 : 0.2 + 2 * random.nextDouble();
        return random.nextBoolean() ? size : -size;
    }

    View view() {
        var projection = new Projection(
                Math.toRadians(20 + 80 * random.nextDouble()),
                1,
                0.05 + random.nextDouble(),
                3 + 30 * random.nextDouble());
        return View.lookAt(point(6), point(6), point(1), projection);
    }

    double seconds() {
        return 100 * random.nextDouble();
    }

    private Vec3 point(double reach) {
        return new Vec3(coordinate(reach), coordinate(reach), coordinate(reach));
    }

    private double coordinate(double reach) {
        return reach * (2 * random.nextDouble() - 1);
    }
}

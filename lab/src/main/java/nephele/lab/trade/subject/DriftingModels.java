package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;
import nephele.engine.math.Vec3;
import nephele.engine.scene.Projection;
import nephele.engine.scene.View;
import nephele.scenes.xml.Dialect;
import nephele.scenes.xml.XmlGroup;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlModel;
import nephele.scenes.xml.XmlScene;

/**
 * A scene of 2 000 primitives in nested groups that are moved, rotated and scaled, some of them animated; and views of
 * it.
 */
final class DriftingModels {
    private static final int GROUPS = 250;
    private static final int MODELS_PER_GROUP = 8;
    private static final double WIDTH = 90;
    private static final List<String> SHAPES =
            List.of("box_1_2.3d", "sphere_0.7_10_8.3d", "cone_0.6_1.5_10_4.3d", "torus_0.8_0.2_12_8.3d");
    private static final XmlModel.Colours COLOURS =
            new XmlModel.Colours(new Vec3(0.8, 0.8, 0.8), Vec3.ZERO, Vec3.ZERO, Vec3.ZERO, 0);

    private final SplittableRandom random = new SplittableRandom(3);

    XmlScene scene() {
        List<XmlGroup> groups = new ArrayList<>();
        for (int i = 0; i < GROUPS; i++) {
            List<XmlGroup> within = new ArrayList<>();
            for (int j = 0; j < MODELS_PER_GROUP; j++) {
                within.add(new XmlGroup(0, steps(8, j > 5 ? spin() : turn()), List.of(), List.of(model()), List.of()));
            }
            groups.add(new XmlGroup(0, steps(WIDTH, turn()), List.of(), List.of(), within));
        }
        XmlGroup root = new XmlGroup(0, List.of(), List.of(), List.of(), groups);
        var eye = new XmlScene.Eye(Vec3.ZERO, new Vec3(0, 0, -1), new Vec3(0, 1, 0), 60, 1, 200);
        return new XmlScene(Dialect.WORLD, new XmlScene.Window(1280, 720), eye, List.of(), root, List.of());
    }

    /** Returns a rotation followed by a translation and a scale, as scene files write orbits. */
    private List<Step> steps(double width, Step rotation) {
        List<Step> steps = new ArrayList<>();
        steps.add(rotation);
        steps.add(new Step.Translate(anywhere(width)));
        double scale = random.nextDouble(0.5, 1.5);
        steps.add(new Step.Scale(new Vec3(scale, scale * random.nextDouble(0.7, 1.4), scale)));
        return steps;
    }

    private Step spin() {
        return new Step.Spin(anywhere(1), random.nextDouble(4, 20));
    }

    private Step turn() {
        return new Step.Rotate(anywhere(1), random.nextDouble(360));
    }

    private XmlModel model() {
        return new XmlModel(0, SHAPES.get(random.nextInt(SHAPES.size())), null, COLOURS);
    }

    private Vec3 anywhere(double width) {
        return new Vec3(offset(width), offset(width), offset(width));
    }

    private double offset(double width) {
        return width * (random.nextDouble() - 0.5);
    }

    /** Returns views from random places among the models towards others. */
    List<View> views(XmlScene scene, int count) {
        XmlScene.Eye eye = scene.eye();
        var projection = new Projection(Math.toRadians(eye.fovDegrees()), 16.0 / 9, eye.near(), eye.far());
        List<View> views = new ArrayList<>();
        for (int i = 0; i < count; i++) {
            Vec3 from = anywhere(WIDTH);
            views.add(View.lookAt(from, anywhere(WIDTH), eye.up(), projection));
        }
        return views;
    }
}

package nephele.engine.render.fixed;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.math.Vec3;
import nephele.engine.xmlscene.XmlGroup;
import nephele.engine.xmlscene.XmlGroup.Step;
import nephele.engine.xmlscene.XmlLight;
import nephele.engine.xmlscene.XmlModel;
import nephele.engine.xmlscene.XmlScene;
import org.joml.Matrix4d;
import org.joml.Matrix4dc;

/** A scene's models and lights in one list each, with their places at a time. */
final class ScenePoses {
    private final List<Group> groups = new ArrayList<>();
    private final List<Placed<XmlModel>> models = new ArrayList<>();
    private final List<Placed<XmlLight>> lights = new ArrayList<>();

    /** @param lightBefore for a model, the last of its lights; for a light, the next of the chain; -1 for none */
    record Placed<T>(T what, Group group, int lightBefore) {}

    /** A frame in the world. */
    static final class Group {
        private final Group parent;
        private final List<Step> steps;
        private final boolean moves;
        private final Matrix4d place = new Matrix4d();

        Group(Group parent, List<Step> steps) {
            this.parent = parent;
            this.steps = steps;
            boolean own = steps.stream().anyMatch(step -> step instanceof Step.Follow || step instanceof Step.Spin);
            moves = own || parent != null && parent.moves;
        }

        boolean moves() {
            return moves;
        }

        Matrix4dc place() {
            return place;
        }

        void pose(double seconds) {
            if (parent == null) {
                place.identity();
            } else {
                place.set(parent.place);
            }
            steps.forEach(step -> apply(step, seconds));
        }

        private void apply(Step step, double seconds) {
            if (step instanceof Step.Translate translate) {
                place.translate(
                        translate.by().x(), translate.by().y(), translate.by().z());
            } else if (step instanceof Step.Scale scale) {
                place.scale(scale.by().x(), scale.by().y(), scale.by().z());
            } else if (step instanceof Step.Rotate rotate) {
                rotate(rotate.axis(), Math.toRadians(rotate.angleDegrees()));
            } else if (step instanceof Step.Spin spin) {
                rotate(spin.axis(), 2 * Math.PI * (seconds / spin.seconds() % 1));
            }
        }

        private void rotate(Vec3 axis, double radians) {
            var unit = axis.toVector();
            if (unit.lengthSquared() > 0) {
                unit.normalize();
                place.rotate(radians, unit.x, unit.y, unit.z);
            }
        }
    }

    ScenePoses(XmlScene scene) {
        Group world = new Group(null, List.of());
        int last = addLights(scene.lights(), world, -1);
        add(scene.root(), world, last);
        set(0);
    }

    private int addLights(List<XmlLight> added, Group group, int last) {
        int before = last;
        for (XmlLight light : added) {
            lights.add(new Placed<>(light, group, before));
            before = lights.size() - 1;
        }
        return before;
    }

    private void add(XmlGroup group, Group parent, int lastLight) {
        Group own = new Group(parent, group.steps());
        groups.add(own);
        int last = addLights(group.lights(), own, lastLight);
        group.models().forEach(model -> models.add(new Placed<>(model, own, last)));
        group.groups().forEach(below -> add(below, own, last));
    }

    void set(double seconds) {
        for (int i = 0; i < groups.size(); i++) {
            groups.get(i).pose(seconds);
        }
    }

    List<Placed<XmlModel>> models() {
        return models;
    }

    List<Placed<XmlLight>> lights() {
        return lights;
    }
}

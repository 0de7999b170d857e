package nephele.lab.trade.subject;

import java.util.ArrayList;
import java.util.EnumSet;
import java.util.List;
import java.util.Set;
import nephele.engine.math.Rotations;
import nephele.engine.math.Vec3;
import nephele.engine.model.BoundingSphere;
import nephele.engine.model.Mesh;
import nephele.engine.scene.View;
import nephele.scenes.xml.XmlGroup;
import nephele.scenes.xml.XmlGroup.Step;
import nephele.scenes.xml.XmlScene;
import org.joml.Quaterniond;
import org.joml.Vector3d;

/** Culling by spheres as in the scene-engine report, with all or some of its errors. Models are in document order. */
final class ReportCulling {
    /** An error of the report. */
    enum Fault {
        /** The sphere is centred at a model's origin, and its radius is the largest of the model's coordinates. */
        LARGEST_COORDINATE,
        /** A rotation replaces those of the enclosing groups instead of being composed with them. */
        LAST_ROTATION,
        /** The right plane goes through the left plane's point. */
        LEFT_POINT
    }

    private final Set<Fault> faults;
    /** For each model the steps of all enclosing groups, the outermost first. */
    private final List<List<Step>> steps = new ArrayList<>();
    /** For each model its sphere before the steps. */
    private final List<BoundingSphere> spheres = new ArrayList<>();

    private final Vector3d place = new Vector3d();
    private final Quaterniond turn = new Quaterniond();
    private final Vector3d scale = new Vector3d();
    private final Vector3d centre = new Vector3d();

    ReportCulling(XmlScene scene, StillLife.Generated files, Set<Fault> faults) {
        this.faults = faults.isEmpty() ? EnumSet.noneOf(Fault.class) : EnumSet.copyOf(faults);
        add(scene.root(), List.of(), files);
    }

    private void add(XmlGroup group, List<Step> above, StillLife.Generated files) {
        List<Step> down = new ArrayList<>(above);
        down.addAll(group.steps());
        group.models().forEach(model -> {
            steps.add(down);
            spheres.add(sphere(files.mesh(model)));
        });
        group.groups().forEach(below -> add(below, down, files));
    }

    private BoundingSphere sphere(Mesh mesh) {
        if (faults.contains(Fault.LARGEST_COORDINATE)) {
            double largest = 0;
            for (float coordinate : mesh.positions()) {
                largest = Math.max(largest, Math.abs(coordinate));
            }
            return new BoundingSphere(Vec3.ZERO, largest);
        }
        return BoundingSphere.of(mesh);
    }

    /** Returns true if the model is kept. */
    boolean keeps(int model, double seconds, View view) {
        BoundingSphere sphere = spheres.get(model);
        place.set(0);
        turn.identity();
        scale.set(1);
        steps.get(model).forEach(step -> apply(step, seconds));
        Vec3 c = sphere.centre();
        turn.transform(centre.set(c.x(), c.y(), c.z()).mul(scale)).add(place);
        double radius = sphere.radius() * Math.max(scale.x, Math.max(scale.y, scale.z));
        return isInside(view, radius);
    }

    private void apply(Step step, double seconds) {
        if (step instanceof Step.Translate translate) {
            Vec3 by = translate.by();
            place.add(turn.transform(centre.set(by.x(), by.y(), by.z()).mul(scale)));
        } else if (step instanceof Step.Scale by) {
            scale.mul(by.by().x(), by.by().y(), by.by().z());
        } else if (step instanceof Step.Rotate rotate) {
            turn(rotate.axis(), Math.toRadians(rotate.angleDegrees()));
        } else if (step instanceof Step.Spin spin) {
            turn(spin.axis(), 2 * Math.PI * (seconds / spin.seconds() % 1));
        }
    }

    private void turn(Vec3 axis, double radians) {
        Quaterniond added = Rotations.aroundAxis(axis, radians);
        if (faults.contains(Fault.LAST_ROTATION)) {
            turn.set(added);
        } else {
            turn.mul(added);
        }
    }

    /** Tests the sphere against six planes, each given by a point and the inward normal. */
    private boolean isInside(View view, double radius) {
        double x = centre.x - view.eyeX();
        double y = centre.y - view.eyeY();
        double z = centre.z - view.eyeZ();
        double right = view.alongRight(x, y, z);
        double up = view.alongUp(x, y, z);
        double ahead = -view.alongBack(x, y, z);
        double near = view.projection().nearMetres();
        double tanX = view.projection().tanHalfWidth();
        double tanY = view.projection().tanHalfHeight();
        double rightPoint = faults.contains(Fault.LEFT_POINT) ? -near * tanX : near * tanX;
        return ahead - near >= -radius
                && view.projection().farMetres() - ahead >= -radius
                && side(right + near * tanX, ahead - near, tanX) >= -radius
                && side(rightPoint - right, ahead - near, tanX) >= -radius
                && side(up + near * tanY, ahead - near, tanY) >= -radius
                && side(near * tanY - up, ahead - near, tanY) >= -radius;
    }

    /**
     * Returns the distance inwards from a side's plane.
     *
     * @param inwards coordinate inwards from the plane's point
     * @param ahead coordinate ahead of the plane's point
     */
    private static double side(double inwards, double ahead, double tan) {
        return (inwards + tan * ahead) / Math.sqrt(1 + tan * tan);
    }
}

package nephele.engine.render.fixed;

import java.util.HashMap;
import java.util.Map;
import nephele.engine.math.Frustum;
import nephele.engine.model.Mesh;
import nephele.engine.render.fixed.ModelOrder.Run;
import org.joml.Matrix4d;

/** A sphere around each model in the world. */
final class ModelSpheres {
    /** Places are rounded to float, whose last bit is worth 2⁻²⁴ of a coordinate; with room for the sums of a product. */
    private static final double ROUNDING = 0x1p-21;

    private final BoundingSphere[] inModel;
    private final double[] inWorld;

    ModelSpheres(ModelOrder order) {
        int count = order.models().size();
        inModel = new BoundingSphere[count];
        inWorld = new double[4 * count];
        Map<Mesh, BoundingSphere> known = new HashMap<>();
        for (Run run : order.runs()) {
            BoundingSphere sphere = known.computeIfAbsent(run.kind().mesh(), BoundingSphere::of);
            for (int number = run.first(); number < run.end(); number++) {
                inModel[number] = sphere;
            }
        }
    }

    void place(int number, Matrix4d place) {
        BoundingSphere sphere = inModel[number];
        double x = place.m00() * sphere.x() + place.m10() * sphere.y() + place.m20() * sphere.z() + place.m30();
        double y = place.m01() * sphere.x() + place.m11() * sphere.y() + place.m21() * sphere.z() + place.m31();
        double z = place.m02() * sphere.x() + place.m12() * sphere.y() + place.m22() * sphere.z() + place.m32();
        double radius = sphere.radius() * greatestStretch(place);
        inWorld[4 * number] = x;
        inWorld[4 * number + 1] = y;
        inWorld[4 * number + 2] = z;
        double magnitude = Math.abs(x) + Math.abs(y) + Math.abs(z) + radius;
        inWorld[4 * number + 3] = radius + ROUNDING * magnitude;
    }

    private static double greatestStretch(Matrix4d m) {
        return Math.sqrt(m.m00() * m.m00()
                + m.m01() * m.m01()
                + m.m02() * m.m02()
                + m.m10() * m.m10()
                + m.m11() * m.m11()
                + m.m12() * m.m12()
                + m.m20() * m.m20()
                + m.m21() * m.m21()
                + m.m22() * m.m22());
    }

    boolean mayBeSeen(int number, Frustum frustum) {
        int at = 4 * number;
        return frustum.maySee(inWorld[at], inWorld[at + 1], inWorld[at + 2], inWorld[at + 3]);
    }
}

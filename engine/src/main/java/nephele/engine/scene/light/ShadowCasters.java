package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/** Which solids can throw a shadow on another: a ground that lies behind everything need not be in the depth map. */
public final class ShadowCasters {
    private static final double TOUCH_METRES = 1e-6;

    private ShadowCasters() {}

    /** Solids without those that have all others before one of their sunny faces. A convex solid never shades itself. */
    public static List<Brush> of(List<Brush> brushes, Vec3 towardsSun) {
        List<Brush> casters = new ArrayList<>();
        for (Brush brush : brushes) {
            if (!isBehindAllOthers(brush, brushes, towardsSun)) {
                casters.add(brush);
            }
        }
        return casters;
    }

    private static boolean isBehindAllOthers(Brush brush, List<Brush> brushes, Vec3 towardsSun) {
        for (ConvexPolyhedron.Face face : brush.shape().faces()) {
            Plane plane = face.plane();
            boolean isSunny =
                    plane.nx() * towardsSun.x() + plane.ny() * towardsSun.y() + plane.nz() * towardsSun.z() > 0;
            if (isSunny && brushes.stream().allMatch(other -> other == brush || isBefore(other, plane))) {
                return true;
            }
        }
        return false;
    }

    private static boolean isBefore(Brush other, Plane plane) {
        for (Vec3 p : other.shape().vertices()) {
            if (plane.signedDistance(p) < -TOUCH_METRES) {
                return false;
            }
        }
        return true;
    }
}

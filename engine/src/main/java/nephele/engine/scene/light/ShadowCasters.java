package nephele.engine.scene.light;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import nephele.engine.level.Brush;
import nephele.engine.math.ConvexPolyhedron;
import nephele.engine.math.Frustum;
import nephele.engine.math.Plane;
import nephele.engine.math.SpatialIndex;
import nephele.engine.math.Vec3;

/** Which solids can throw a shadow on another: a ground that lies behind everything need not be in the depth map. */
public final class ShadowCasters {
    private static final double TOUCH_METRES = 1e-6;

    private final List<Brush> brushes;
    private final SpatialIndex index;

    private ShadowCasters(List<Brush> brushes) {
        this.brushes = brushes;
        index = SpatialIndex.of(
                brushes.stream().map(brush -> brush.shape().bounds()).toList());
    }

    /** Whether {@link #of} holds any: stops at the first. */
    public static boolean any(List<Brush> brushes, Vec3 towardsSun) {
        ShadowCasters search = new ShadowCasters(brushes);
        return IntStream.range(0, brushes.size()).anyMatch(i -> !search.isBehindAllOthers(i, towardsSun));
    }

    /** Solids without those that have all others before one of their sunny faces. A convex solid never shades itself. */
    public static List<Brush> of(List<Brush> brushes, Vec3 towardsSun) {
        List<Brush> casters = new ArrayList<>();
        ShadowCasters search = new ShadowCasters(brushes);
        for (int i = 0; i < brushes.size(); i++) {
            if (!search.isBehindAllOthers(i, towardsSun)) {
                casters.add(brushes.get(i));
            }
        }
        return casters;
    }

    private boolean isBehindAllOthers(int brush, Vec3 towardsSun) {
        for (ConvexPolyhedron.Face face : brushes.get(brush).shape().faces()) {
            Plane plane = face.plane();
            boolean isSunny =
                    plane.nx() * towardsSun.x() + plane.ny() * towardsSun.y() + plane.nz() * towardsSun.z() > 0;
            if (isSunny && !isAnyOtherBelow(brush, plane)) {
                return true;
            }
        }
        return false;
    }

    private boolean isAnyOtherBelow(int brush, Plane plane) {
        Frustum below =
                Frustum.inFrontOnly(new Plane(-plane.nx(), -plane.ny(), -plane.nz(), TOUCH_METRES - plane.distance()));
        boolean[] found = {false};
        index.cull(below, (first, end) -> {
            for (int slot = first; slot < end && !found[0]; slot++) {
                int other = index.itemAt(slot);
                found[0] = other != brush && reachesBelow(brushes.get(other), plane);
            }
        });
        return found[0];
    }

    private static boolean reachesBelow(Brush other, Plane plane) {
        for (Vec3 p : other.shape().vertices()) {
            if (plane.signedDistance(p) < -TOUCH_METRES) {
                return true;
            }
        }
        return false;
    }
}

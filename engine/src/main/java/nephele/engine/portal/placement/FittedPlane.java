package nephele.engine.portal.placement;

import java.util.List;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/** Fits a plane to patches whose corners are slightly off it. */
final class FittedPlane {
    private FittedPlane() {}

    /**
     * Returns the frame of a least-squares plane: the mean normal gives a frame, and a fit over the heights of all
     * corners in it gives the plane. Each patch is weighted by its area.
     */
    static PlaneFrame of(List<Patch> patches) {
        Vector3d normal = new Vector3d();
        Vector3d middle = new Vector3d();
        double weight = 0;
        Vec3 first = patches.get(0).corners().get(0);
        for (Patch patch : patches) {
            double area = patch.areaSquareMetres();
            normal.fma(area, patch.normal().toVector());
            for (Vec3 corner : patch.corners()) {
                middle.fma(area / patch.corners().size(), corner.minus(first).toVector());
            }
            weight += area;
        }
        middle.div(weight);
        Vec3 centre = new Vec3(first.x() + middle.x, first.y() + middle.y, first.z() + middle.z);
        return levelled(PlaneFrame.of(centre, new Vec3(normal.x, normal.y, normal.z)), patches);
    }

    /** Uses the mean of the corners as origin, so that height = slopeX · x + slopeY · y is the best fit. */
    private static PlaneFrame levelled(PlaneFrame frame, List<Patch> patches) {
        double xx = 0;
        double xy = 0;
        double yy = 0;
        double xh = 0;
        double yh = 0;
        for (Patch patch : patches) {
            double weight = patch.areaSquareMetres() / patch.corners().size();
            for (Vec3 corner : patch.corners()) {
                double x = frame.x(corner);
                double y = frame.y(corner);
                double height = frame.height(corner);
                xx += weight * x * x;
                xy += weight * x * y;
                yy += weight * y * y;
                xh += weight * x * height;
                yh += weight * y * height;
            }
        }
        double determinant = xx * yy - xy * xy;
        if (!(determinant > 1e-12 * xx * yy)) {
            return frame;
        }
        double slopeX = (yy * xh - xy * yh) / determinant;
        double slopeY = (xx * yh - xy * xh) / determinant;
        Vector3d normal = frame.normal()
                .toVector()
                .fma(-slopeX, frame.axes().right().toVector())
                .fma(-slopeY, frame.axes().up().toVector());
        return PlaneFrame.of(frame.origin(), new Vec3(normal.x, normal.y, normal.z));
    }
}

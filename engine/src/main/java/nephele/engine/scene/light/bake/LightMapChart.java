package nephele.engine.scene.light.bake;

import java.util.List;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * A rectangle over a face fragment with its outermost texel centres on the fragment's border: interpolation never
 * leaves the chart, so charts need no gutter and borders are sampled exactly.
 *
 * @param outline the fragment's corners
 * @param across unit vector in the plane, {@code up} the other; {@code normal} is outward
 * @param minAcross least coordinate along {@code across}, metres; {@code minUp} along {@code up}
 * @param columns at least 2, likewise {@code rows}
 */
public record LightMapChart(
        List<Vec3> outline,
        Vector3d normal,
        Vector3d across,
        Vector3d up,
        double minAcross,
        double minUp,
        double widthMetres,
        double heightMetres,
        int columns,
        int rows) {
    /**
     * The greatest side of a chart: a face longer than 64 m gets larger texels of its own, so that one huge ground does
     * not coarsen the rest.
     */
    private static final int MAX_SIDE_TEXELS = 257;

    static LightMapChart over(List<Vec3> outline, Plane plane, double texelMetres) {
        Vector3d normal = new Vector3d(plane.nx(), plane.ny(), plane.nz());
        Vector3d across = longestEdge(outline);
        Vector3d up = normal.cross(across, new Vector3d());
        double[] extent = {Double.MAX_VALUE, Double.MAX_VALUE, -Double.MAX_VALUE, -Double.MAX_VALUE};
        for (Vec3 p : outline) {
            double s = across.dot(p.x(), p.y(), p.z());
            double t = up.dot(p.x(), p.y(), p.z());
            extent[0] = Math.min(extent[0], s);
            extent[1] = Math.min(extent[1], t);
            extent[2] = Math.max(extent[2], s);
            extent[3] = Math.max(extent[3], t);
        }
        double width = extent[2] - extent[0];
        double height = extent[3] - extent[1];
        return new LightMapChart(
                outline,
                normal,
                across,
                up,
                extent[0],
                extent[1],
                width,
                height,
                texels(width, texelMetres),
                texels(height, texelMetres));
    }

    private static Vector3d longestEdge(List<Vec3> outline) {
        Vector3d longest = new Vector3d();
        for (int i = 0; i < outline.size(); i++) {
            Vector3d edge = outline.get((i + 1) % outline.size())
                    .toVector()
                    .sub(outline.get(i).toVector());
            if (edge.lengthSquared() > longest.lengthSquared() * (1 + 1e-9)) {
                longest = edge;
            }
        }
        return longest.normalize();
    }

    private static int texels(double metres, double texelMetres) {
        return Math.max(2, (int) Math.min(Math.ceil(metres / texelMetres - 1e-6) + 1, MAX_SIDE_TEXELS));
    }

    /** Returns the point of the fragment nearest to a (fractional) texel position, at a distance from the border. */
    public Vector3d inside(double column, double row) {
        return clampedIntoOutline(pointAt(column, row), insetMetres());
    }

    /** Returns the world position of a texel position in the plane, which may be outside of the fragment. */
    public Vector3d pointAt(double column, double row) {
        double s = minAcross + widthMetres * column / (columns - 1);
        double t = minUp + heightMetres * row / (rows - 1);
        Vec3 corner = outline.get(0);
        double distance = normal.dot(corner.x(), corner.y(), corner.z());
        return new Vector3d(normal).mul(distance).fma(s, across).fma(t, up);
    }

    /** Returns the column of a point on the fragment; 0 is the centre of the first column. */
    public double columnOf(Vec3 p) {
        double s = (across.dot(p.x(), p.y(), p.z()) - minAcross) / widthMetres;
        return Math.min(Math.max(s, 0), 1) * (columns - 1);
    }

    public double rowOf(Vec3 p) {
        double t = (up.dot(p.x(), p.y(), p.z()) - minUp) / heightMetres;
        return Math.min(Math.max(t, 0), 1) * (rows - 1);
    }

    /** Returns the distance of a point of the plane to the rectangle, 0 inside. */
    public double metresTo(Vec3 p) {
        double s = across.dot(p.x(), p.y(), p.z()) - minAcross;
        double t = up.dot(p.x(), p.y(), p.z()) - minUp;
        return Math.hypot(Math.max(0, Math.max(-s, s - widthMetres)), Math.max(0, Math.max(-t, t - heightMetres)));
    }

    /** Returns how far a point of the plane is outside the fragment, metres; negative inside. */
    public double metresOutside(Vec3 p) {
        double farthest = Double.NEGATIVE_INFINITY;
        for (int i = 0; i < outline.size(); i++) {
            Vec3 a = outline.get(i);
            Vec3 edge = outline.get((i + 1) % outline.size()).minus(a);
            double dx = p.x() - a.x();
            double dy = p.y() - a.y();
            double dz = p.z() - a.z();
            double crossX = edge.y() * normal.z - edge.z() * normal.y;
            double crossY = edge.z() * normal.x - edge.x() * normal.z;
            double crossZ = edge.x() * normal.y - edge.y() * normal.x;
            double length = Math.sqrt(crossX * crossX + crossY * crossY + crossZ * crossZ);
            farthest = Math.max(farthest, (dx * crossX + dy * crossY + dz * crossZ) / length);
        }
        return farthest;
    }

    /** Returns the nearest point of the fragment at a distance of {@code inset} from its border. */
    private Vector3d clampedIntoOutline(Vector3d p, double inset) {
        Vector3d q = new Vector3d(p);
        // Two rounds suffice for a corner between two edges; sharper corners may keep a fraction of the inset.
        for (int round = 0; round < 4; round++) {
            for (int i = 0; i < outline.size(); i++) {
                Vector3d a = outline.get(i).toVector();
                Vector3d inward =
                        outline.get((i + 1) % outline.size()).toVector().sub(a);
                normal.cross(inward, inward).normalize();
                double depth = new Vector3d(q).sub(a).dot(inward);
                if (depth < inset) {
                    q.fma(inset - depth, inward);
                }
            }
        }
        return q;
    }

    /** Returns the inset; a small fragment is sampled near its centre. */
    double insetMetres() {
        return Math.min(2e-3, 0.25 * Math.min(widthMetres, heightMetres));
    }
}

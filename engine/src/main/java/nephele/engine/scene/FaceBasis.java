package nephele.engine.scene;

import java.util.List;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.TextureMapping;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * How a texture lies on a face: {@code s} to the right and {@code t} upwards when the face is looked at with world up
 * upwards (for floors and ceilings: s along +x). The solid shader derives the same two directions for normal maps.
 */
record FaceBasis(Vector3d s, Vector3d t) {
    /** Faces steeper than this sine of inclination to the horizontal count as floor or ceiling. */
    private static final double HORIZONTAL = 0.999;

    static FaceBasis of(Vec3 normal) {
        Vector3d n = normal.toVector();
        Vector3d s = Math.abs(n.y) > HORIZONTAL
                ? new Vector3d(1, 0, 0).sub(new Vector3d(n).mul(n.x))
                : new Vector3d(0, 1, 0).cross(n);
        s.normalize();
        return new FaceBasis(s, new Vector3d(n).cross(s));
    }

    /**
     * Texture coordinates of points on a face, s and t in turn, t = 0 at the picture's top row.
     *
     * @param metres side of the square that one repeat covers
     */
    static double[] coordinates(BrushFace face, List<Vec3> points, double metres) {
        FaceBasis basis = of(face.plane().normal());
        double[] outline = basis.projected(face.polygon());
        double[] st = points == face.polygon() ? outline.clone() : basis.projected(points);
        for (int axis = 0; axis < 2; axis++) {
            double min = Double.POSITIVE_INFINITY;
            double max = Double.NEGATIVE_INFINITY;
            for (int i = axis; i < outline.length; i += 2) {
                min = Math.min(min, outline[i]);
                max = Math.max(max, outline[i]);
            }
            boolean stretched = face.textureMapping() == TextureMapping.FACE;
            // Whole repeats are taken off, so that floats stay exact far from the origin.
            double whole = Math.floor(min / metres);
            for (int i = axis; i < st.length; i += 2) {
                st[i] = stretched ? (st[i] - min) / (max - min) : st[i] / metres - whole;
            }
        }
        return st;
    }

    private double[] projected(List<Vec3> points) {
        double[] st = new double[2 * points.size()];
        for (int i = 0; i < points.size(); i++) {
            Vector3d p = points.get(i).toVector();
            st[2 * i] = p.dot(s);
            st[2 * i + 1] = -p.dot(t);
        }
        return st;
    }
}

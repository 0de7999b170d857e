package nephele.editor.proving;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.Brush;
import nephele.engine.level.Brush.BrushFace;
import nephele.engine.level.layout.FacePieces;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Basis;
import nephele.engine.math.Directions;
import nephele.engine.math.Plane;
import nephele.engine.math.Vec3;

/**
 * A flat convex piece of surface with a grid on it.
 *
 * @param axes right and up along the surface, back along its normal
 */
record HeatSurface(List<Vec3> corners, boolean portalable, Basis axes) {
    /** |N.y| from which a view straight at a surface has no heading of its own. */
    private static final double LEVEL = 0.999;

    private static final double ON_METRES = 0.01;

    private static final double LEAST_SQUARE_METRES = 1e-6;

    private static final Vec3 UP = new Vec3(0, 1, 0);

    /** Returns all surfaces: of solids, of convex models, and the triangles of other models. */
    static List<HeatSurface> all(StaticShapes statics) {
        List<HeatSurface> all = new ArrayList<>();
        List<Brush> brushes = new ArrayList<>(statics.solids());
        brushes.addAll(statics.models().solids());
        for (Brush brush : brushes) {
            for (BrushFace face : brush.faces()) {
                add(face.polygon(), face.portalable(), face.plane().normal(), all);
            }
        }
        for (PlacedModel model : statics.models().sheets()) {
            WorldTriangles mesh = model.triangles();
            for (int i = 0; i < mesh.count(); i++) {
                List<Vec3> corners = List.of(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2));
                Vec3 area = corners.get(1)
                        .minus(corners.get(0))
                        .cross(corners.get(2).minus(corners.get(0)));
                add(corners, model.authored().portalable(), Directions.unit(area), all);
            }
        }
        return all;
    }

    private static void add(List<Vec3> corners, boolean portalable, Vec3 normal, List<HeatSurface> all) {
        if (normal != null && FacePieces.areaSquareMetres(corners) > LEAST_SQUARE_METRES) {
            Basis axes = Basis.lookAt(normal, Vec3.ZERO, UP, Basis.WORLD);
            all.add(new HeatSurface(corners, portalable, axes));
        }
    }

    Vec3 normal() {
        return axes.back();
    }

    /** Returns true if a point lies on the surface, within a centimetre. */
    boolean holds(Vec3 point) {
        Vec3 first = corners.get(0);
        if (Math.abs(point.minus(first).dot(normal())) > ON_METRES) {
            return false;
        }
        for (int i = 0; i < corners.size(); i++) {
            Vec3 side = corners.get((i + 1) % corners.size()).minus(corners.get(i));
            double inside = normal().cross(side).dot(point.minus(corners.get(i)));
            if (inside < -ON_METRES * side.length()) {
                return false;
            }
        }
        return true;
    }

    /** Returns the view straight at the surface. */
    Basis view(double yawRadians) {
        double y = normal().y();
        return Math.abs(y) < LEVEL ? axes : Basis.ofYawPitch(yawRadians, y > 0 ? -Math.PI / 2 : Math.PI / 2);
    }

    /** Returns the number of cells of the grid that its bounding rectangle touches. */
    long cells(double spacing) {
        return span(axes.right(), spacing) * span(axes.up(), spacing);
    }

    private long span(Vec3 axis, double spacing) {
        return 1 + last(axis, spacing) - first(axis, spacing);
    }

    private long first(Vec3 axis, double spacing) {
        double least = corners.stream().mapToDouble(axis::dot).min().orElseThrow();
        return (long) Math.floor(least / spacing);
    }

    private long last(Vec3 axis, double spacing) {
        double greatest = corners.stream().mapToDouble(axis::dot).max().orElseThrow();
        return (long) Math.ceil(greatest / spacing) - 1;
    }

    /** Returns the pieces into which the grid divides the surface. */
    List<List<Vec3>> pieces(double spacing) {
        List<List<Vec3>> pieces = new ArrayList<>();
        for (List<Vec3> column : strips(corners, axes.right(), spacing)) {
            pieces.addAll(strips(column, axes.up(), spacing));
        }
        return pieces;
    }

    private List<List<Vec3>> strips(List<Vec3> polygon, Vec3 axis, double spacing) {
        List<List<Vec3>> strips = new ArrayList<>();
        long last = last(axis, spacing);
        for (long i = first(axis, spacing); i <= last; i++) {
            List<Vec3> low = FacePieces.behind(polygon, plane(axis, (i + 1) * spacing));
            List<Vec3> strip = low.isEmpty()
                    ? low
                    : FacePieces.behind(low, plane(axis, i * spacing).opposite());
            if (strip.size() >= 3 && FacePieces.areaSquareMetres(strip) > LEAST_SQUARE_METRES) {
                strips.add(List.copyOf(strip));
            }
        }
        return strips;
    }

    private static Plane plane(Vec3 unit, double distance) {
        return new Plane(unit.x(), unit.y(), unit.z(), distance);
    }
}

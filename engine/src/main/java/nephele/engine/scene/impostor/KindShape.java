package nephele.engine.scene.impostor;

import java.util.ArrayList;
import java.util.List;
import nephele.engine.level.billboard.PlantedModels;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;

/**
 * The triangles of a kind in metres from its foot, and the upright cylinder around them.
 *
 * @param centre of the cylinder
 * @param halfWidth its radius
 * @param radius of the sphere around the centre that holds all triangles
 */
public record KindShape(WorldTriangles triangles, Vec3 centre, double halfWidth, double halfHeight, double radius) {
    private static final double LEAST_METRES = 1e-3;

    public static KindShape of(PlantedModels.Kind kind) {
        WorldTriangles triangles = WorldTriangles.of(kind.mesh(), kind.plantFromModel());
        Aabb box = triangles.count() == 0 ? Aabb.of(List.of(Vec3.ZERO)) : triangles.bounds();
        Vec3 centre = box.centre();
        double flat = LEAST_METRES;
        double whole = LEAST_METRES;
        for (int i = 0; i < 3 * triangles.count(); i++) {
            Vec3 p = triangles.corner(i / 3, i % 3).minus(centre);
            flat = Math.max(flat, Math.hypot(p.x(), p.z()));
            whole = Math.max(whole, p.length());
        }
        double halfHeight = Math.max(LEAST_METRES, (box.maxY() - box.minY()) / 2);
        return new KindShape(triangles, centre, flat, halfHeight, whole);
    }

    /** Returns the box of each triangle. */
    List<Aabb> boxes() {
        List<Aabb> boxes = new ArrayList<>();
        for (int i = 0; i < triangles.count(); i++) {
            boxes.add(Aabb.of(List.of(triangles.corner(i, 0), triangles.corner(i, 1), triangles.corner(i, 2))));
        }
        return boxes;
    }
}

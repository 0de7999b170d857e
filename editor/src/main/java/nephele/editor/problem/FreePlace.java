package nephele.editor.problem;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import nephele.editor.document.EntityBounds;
import nephele.engine.level.Body;
import nephele.engine.level.Exit;
import nephele.engine.level.Level;
import nephele.engine.level.layout.BrushIndex;
import nephele.engine.level.placed.PlacedModel;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.level.placed.WorldTriangles;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.bvh.ItemList;
import nephele.engine.math.bvh.SpatialIndex;

/** Finds the free place nearest to where an entity is: along an axis against a surface, else on a grid around it. */
final class FreePlace {
    /** Up first: what is as near goes onto a floor rather than against a wall. */
    private static final List<Vec3> AXES = List.of(
            new Vec3(0, 1, 0),
            new Vec3(1, 0, 0),
            new Vec3(-1, 0, 0),
            new Vec3(0, 0, 1),
            new Vec3(0, 0, -1),
            new Vec3(0, -1, 0));

    private static final int MOST_PUSHES = 64;
    private static final double GRID_METRES = 0.5;
    private static final int GRID_REACH = 12;

    /** Depth up to which boxes only touch. */
    private static final double TOUCHING_METRES = 1e-6;

    private final BrushIndex solids;
    private final List<Aabb> others = new ArrayList<>();
    private final SpatialIndex otherIndex;

    /** @param entity the one that moves, which bars nothing */
    FreePlace(Level level, StaticShapes statics, Object entity) {
        solids = new BrushIndex(statics);
        for (Body body : level.bodies()) {
            if (body != entity) {
                others.add(EntityBounds.of((Record) body));
            }
        }
        if (level.player() != null && level.player() != entity && entity instanceof Body) {
            others.add(EntityBounds.of(level.player()));
        }
        for (PlacedModel model : statics.models().sheets()) {
            WorldTriangles mesh = model.triangles();
            for (int i = 0; i < mesh.count(); i++) {
                others.add(Aabb.of(List.of(mesh.corner(i, 0), mesh.corner(i, 1), mesh.corner(i, 2))));
            }
        }
        otherIndex = SpatialIndex.of(others);
    }

    /** Returns the box that an entity has to have free: at an exit, that of a player; empty for one without a place. */
    static Aabb room(Record entity) {
        return entity instanceof Exit exit ? EntityBounds.standing(exit.feet()) : EntityBounds.of(entity);
    }

    /** Returns true if a box is free; beside slanted faces, only if its surroundings are. */
    boolean isFree(Aabb box) {
        return solids.isFree(box) && overlapping(box).size() == 0;
    }

    private ItemList overlapping(Aabb box) {
        ItemList found = new ItemList();
        otherIndex.overlapping(box.grown(-TOUCHING_METRES), found);
        return found;
    }

    /** Returns the displacement to the nearest free place inside the level's bounds; empty if there is none near. */
    Optional<Vec3> nearest(Aabb box) {
        List<Vec3> displacements = new ArrayList<>();
        for (Vec3 axis : AXES) {
            Vec3 displacement = pushed(box, axis);
            if (displacement != null && isInLevel(box.moved(displacement))) {
                displacements.add(displacement);
            }
        }
        return displacements.isEmpty()
                ? onGrid(box)
                : displacements.stream().min(Comparator.comparingDouble(Vec3::length));
    }

    private boolean isInLevel(Aabb box) {
        Aabb level = solids.bounds();
        return level.overlaps(Aabb.of(List.of(box.centre())));
    }

    /** Pushes a box along an axis until it is free; {@code null} if that takes too many pushes. */
    private Vec3 pushed(Aabb box, Vec3 axis) {
        double metres = 0;
        for (int i = 0; i < MOST_PUSHES; i++) {
            Aabb at = box.moved(axis.scaled(metres));
            if (isFree(at)) {
                return axis.scaled(metres);
            }
            double more = 0;
            ItemList near = solids.near(at.grown(-TOUCHING_METRES));
            for (int j = 0; j < near.size(); j++) {
                more = Math.max(
                        more, past(at, solids.brushes().get(near.get(j)).shape().bounds(), axis));
            }
            ItemList met = overlapping(at);
            for (int j = 0; j < met.size(); j++) {
                more = Math.max(more, past(at, others.get(met.get(j)), axis));
            }
            metres += more;
        }
        return null;
    }

    /** Returns how far a box has to go along an axis until it has passed another. */
    private static double past(Aabb box, Aabb other, Vec3 axis) {
        double sum = axis.x() + axis.y() + axis.z();
        if (sum > 0) {
            return axis.x() * (other.maxX() - box.minX())
                    + axis.y() * (other.maxY() - box.minY())
                    + axis.z() * (other.maxZ() - box.minZ());
        }
        return axis.x() * (other.minX() - box.maxX())
                + axis.y() * (other.minY() - box.maxY())
                + axis.z() * (other.minZ() - box.maxZ());
    }

    private Optional<Vec3> onGrid(Aabb box) {
        List<Vec3> displacements = new ArrayList<>();
        for (int x = -GRID_REACH; x <= GRID_REACH; x++) {
            for (int y = -GRID_REACH; y <= GRID_REACH; y++) {
                for (int z = -GRID_REACH; z <= GRID_REACH; z++) {
                    displacements.add(new Vec3(x * GRID_METRES, y * GRID_METRES, z * GRID_METRES));
                }
            }
        }
        displacements.sort(Comparator.comparingDouble(Vec3::length));
        return displacements.stream()
                .filter(displacement -> isFree(box.moved(displacement)) && isInLevel(box.moved(displacement)))
                .findFirst();
    }
}

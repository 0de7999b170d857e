package nephele.engine.level.placed;

import java.util.Optional;
import java.util.function.Consumer;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Brush;
import nephele.engine.level.Terrain;
import nephele.engine.math.Aabb;
import nephele.engine.math.heightfield.HeightField;

/** A static shape of a level, in the world. */
public sealed interface StaticShape {
    Aabb bounds();

    /** Calls the function for this kind; a new kind is a new parameter, so that the compiler names every caller. */
    void select(Consumer<ConvexHull> hull, Consumer<TriangleMesh> mesh, Consumer<HeightGrid> grid);

    /**
     * A solid of the level.
     *
     * @param index in the level's list
     */
    record ConvexHull(int index, Brush brush) implements StaticShape {
        @Override
        public Aabb bounds() {
            return brush.shape().bounds();
        }

        @Override
        public void select(Consumer<ConvexHull> hull, Consumer<TriangleMesh> mesh, Consumer<HeightGrid> grid) {
            hull.accept(this);
        }
    }

    /** A model of the level; the interior of a convex and closed one is solid. */
    record TriangleMesh(PlacedModel model) implements StaticShape {
        @Override
        public Aabb bounds() {
            return model.bounds();
        }

        @Override
        public void select(Consumer<ConvexHull> hull, Consumer<TriangleMesh> mesh, Consumer<HeightGrid> grid) {
            mesh.accept(this);
        }
    }

    /**
     * A terrain of the level. It is solid.
     *
     * @param index in the level's list
     * @param painted its layer map, empty if none is seen
     */
    record HeightGrid(int index, Terrain authored, HeightField field, Optional<LayerMap> painted)
            implements StaticShape {
        /** Creates a terrain without painted layers. */
        public HeightGrid(int index, Terrain authored, HeightField field) {
            this(index, authored, field, Optional.empty());
        }

        public String id() {
            return authored.id();
        }

        @Override
        public Aabb bounds() {
            return field.bounds();
        }

        @Override
        public void select(Consumer<ConvexHull> hull, Consumer<TriangleMesh> mesh, Consumer<HeightGrid> grid) {
            grid.accept(this);
        }
    }
}

package nephele.engine.level.placed;

import java.util.Optional;
import nephele.engine.asset.LayerMap;
import nephele.engine.level.Brush;
import nephele.engine.level.Terrain;
import nephele.engine.math.Aabb;
import nephele.engine.math.heightfield.HeightField;

/**
 * A static shape. Code that treats the kinds differently implements {@link Cases}, so that a new kind is a compile
 * error wherever it is not handled.
 */
public sealed interface StaticShape {
    Aabb bounds();

    /** Calls the case of this kind. */
    void select(Cases cases);

    /** One method for each kind. */
    interface Cases {
        void convexHull(ConvexHull hull);

        void triangleMesh(TriangleMesh mesh);

        void heightGrid(HeightGrid grid);
    }

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
        public void select(Cases cases) {
            cases.convexHull(this);
        }
    }

    /** A model of the level; the interior of a convex and closed one is solid. */
    record TriangleMesh(PlacedModel model) implements StaticShape {
        @Override
        public Aabb bounds() {
            return model.bounds();
        }

        @Override
        public void select(Cases cases) {
            cases.triangleMesh(this);
        }
    }

    /**
     * A terrain of the level. It is solid.
     *
     * @param index in the level's list
     * @param painted its layer map, empty if none is seen
     */
    record HeightGrid(int index, Terrain said, HeightField field, Optional<LayerMap> painted) implements StaticShape {
        /** Creates a terrain without painted layers. */
        public HeightGrid(int index, Terrain said, HeightField field) {
            this(index, said, field, Optional.empty());
        }

        public String id() {
            return said.id();
        }

        @Override
        public Aabb bounds() {
            return field.bounds();
        }

        @Override
        public void select(Cases cases) {
            cases.heightGrid(this);
        }
    }
}

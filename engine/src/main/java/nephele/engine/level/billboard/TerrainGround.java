package nephele.engine.level.billboard;

import nephele.engine.level.placed.StaticShape;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;
import nephele.engine.math.heightfield.HeightFieldSurface;

/** The surface of a terrain alone, whatever stands on it. */
record TerrainGround(HeightField field) implements Ground {
    static TerrainGround of(StaticShape.HeightGrid grid) {
        return new TerrainGround(grid.field());
    }

    @Override
    public Area area() {
        Aabb bounds = field.bounds();
        return new Area(bounds.minX(), bounds.minZ(), bounds.maxX(), bounds.maxZ());
    }

    @Override
    public Place at(double x, double z) {
        double y = HeightFieldSurface.y(field, x, z);
        return Double.isNaN(y) ? null : new Place(new Vec3(x, y, z), HeightFieldSurface.normal(field, x, z));
    }
}

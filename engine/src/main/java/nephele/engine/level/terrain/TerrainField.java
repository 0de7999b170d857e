package nephele.engine.level.terrain;

import java.util.function.Supplier;
import nephele.engine.asset.AssetException;
import nephele.engine.asset.HeightMap;
import nephele.engine.level.Terrain;
import nephele.engine.math.Vec3;
import nephele.engine.math.heightfield.HeightField;

/** Makes the height field of a terrain. Collision, rays, pictures and the reference path tracer all use its heights. */
public final class TerrainField {
    private TerrainField() {}

    /**
     * Returns the field of a terrain's map.
     *
     * @throws AssetException if the map has more cells than fit into the terrain's size, or does not fit into memory
     */
    public static HeightField of(Terrain authored, HeightMap map) {
        return made(
                authored,
                () -> HeightField.of(
                        origin(authored),
                        cellX(authored, map),
                        cellZ(authored, map),
                        map.columns(),
                        map.rows(),
                        heights(authored, map)));
    }

    /** Returns the same from a field that may differ in few heights. */
    public static HeightField edited(HeightField before, Terrain authored, HeightMap map) {
        boolean hasSameCells = before.cellColumns() == map.columns() - 1
                && before.cellRows() == map.rows() - 1
                && before.cellX() == cellX(authored, map)
                && before.cellZ() == cellZ(authored, map);
        return hasSameCells
                ? made(authored, () -> before.at(origin(authored)).edited(heights(authored, map)))
                : of(authored, map);
    }

    private static double cellX(Terrain authored, HeightMap map) {
        return authored.sizeMetres().x() / (map.columns() - 1);
    }

    private static double cellZ(Terrain authored, HeightMap map) {
        return authored.sizeMetres().z() / (map.rows() - 1);
    }

    private static HeightField.Heights heights(Terrain authored, HeightMap map) {
        double low = authored.heightRangeMetres().low();
        double perValue = (authored.heightRangeMetres().high() - low) / HeightMap.FULL_SCALE;
        return (column, row) -> low + perValue * map.value(column, row);
    }

    private static HeightField made(Terrain authored, Supplier<HeightField> make) {
        try {
            return make.get();
        } catch (IllegalArgumentException unusable) {
            throw new AssetException(
                    authored.heightMap(),
                    "cannot be the ground of '" + authored.id() + "': " + unusable.getMessage(),
                    "change sizeMetres or centre, or scale the map");
        } catch (OutOfMemoryError tooLarge) {
            throw new AssetException(authored.heightMap(), "does not fit into memory", "make the height map smaller");
        }
    }

    /**
     * Checks that a map has cells of a usable size in a terrain.
     *
     * @throws AssetException if it has not
     */
    public static void requireSize(Terrain authored, HeightMap map) {
        of(authored, new HeightMap(2, 2, map.bits(), new short[4]));
        double cell = Math.min(
                authored.sizeMetres().x() / (map.columns() - 1),
                authored.sizeMetres().z() / (map.rows() - 1));
        if (cell < HeightField.LEAST_CELL_METRES) {
            throw new AssetException(
                    authored.heightMap(),
                    "has cells of " + cell + " m in '" + authored.id() + "', at least " + HeightField.LEAST_CELL_METRES
                            + " m are needed",
                    "enlarge sizeMetres, or scale the map");
        }
    }

    /** Returns the position of the first sample for height 0. */
    static Vec3 origin(Terrain authored) {
        return authored.centre()
                .plus(new Vec3(
                        -authored.sizeMetres().x() / 2,
                        0,
                        -authored.sizeMetres().z() / 2));
    }

    /** Returns the field of a terrain that differs in its place alone from the one of {@code field}. */
    public static HeightField moved(HeightField field, Terrain authored) {
        return field.at(origin(authored));
    }

    /** Returns true if two terrains have the same heights at the same distances. */
    public static boolean isSameShape(Terrain a, Terrain b) {
        return a.heightMap().equals(b.heightMap())
                && a.sizeMetres().equals(b.sizeMetres())
                && a.heightRangeMetres().equals(b.heightRangeMetres());
    }
}

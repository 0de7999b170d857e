package nephele.engine.scene.light;

import java.util.List;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * All data about a level's punctual lights that shaders read.
 *
 * @param shadows layers of the depth texture; none if no light casts shadows
 * @param cells the data from which the grid's lists were made
 */
public record LampTable(List<Lamp> lamps, LampGrid grid, LampShadows shadows, LampCells cells) {
    /** The number of texels (of four floats) per light in {@link #packed}. */
    public static final int TEXELS_PER_LAMP = 4;

    private static final Aabb NOTHING_LIT = new Aabb(0, 0, 0, 1, 1, 1);

    /**
     * Makes the table of a level.
     *
     * @param statics shapes that are lit and that cast shadows
     * @return {@code null} if no light reaches anything
     */
    public static LampTable of(Level level, StaticShapes statics) {
        return edited(null, level, statics);
    }

    /**
     * Makes the table of an edited level; returns the same object if nothing in it has changed, and reuses the parts
     * that no change affects.
     *
     * @param before {@code null} if there is none
     * @return {@code null} if no light reaches anything
     */
    public static LampTable edited(LampTable before, Level level, StaticShapes statics) {
        if (!LightNeeds.lamps(level)) {
            return null;
        }
        List<Lamp> lamps = lamps(level.lights());
        if (before == null) {
            return of(lamps, statics.bounds(), statics, null);
        }
        return before.cells.areOf(lamps, statics) ? before : of(lamps, statics.bounds(), statics, before.cells);
    }

    /**
     * Makes a table from lights.
     *
     * @param bounds of the surfaces to light
     */
    static LampTable of(List<Light> lights, Aabb bounds, StaticShapes statics) {
        return of(lamps(lights), bounds, statics, null);
    }

    private static List<Lamp> lamps(List<Light> lights) {
        return lights.stream().flatMap(light -> Lamp.of(light).stream()).toList();
    }

    private static LampTable of(List<Lamp> lamps, Aabb bounds, StaticShapes statics, LampCells before) {
        LampShadows shadows = LampShadows.of(lamps);
        Aabb box = bounds.isEmpty() ? NOTHING_LIT : bounds;
        for (double side = LampGrid.finestMetres(box); ; side *= 2) {
            LampGrid empty = LampGrid.over(box, side);
            LampCells cells = new LampCells(empty, lamps, shadows.firstLayer(), statics, before);
            LampGrid grid = empty.listing(lamps, cells);
            if (grid != null) {
                return new LampTable(lamps, grid, shadows, cells);
            }
        }
    }

    /**
     * Returns a token for everything that may cast a shadow in a light: the same object after an edit as long as
     * neither the light nor anything within its range has changed.
     */
    public Object shade(int lamp) {
        return cells.lit(lamp);
    }

    /**
     * Returns four texels per light: position and 1/range²; intensity and cone scale; axis and cone offset; the shadow
     * picture's right axis times its cotangent (the cotangent alone for six pictures), and the first layer, plus ½ if
     * it is the only one, −1 without a shadow.
     */
    public float[] packed(Vec3 anchor) {
        float[] packed = new float[lamps.size() * TEXELS_PER_LAMP * 4];
        for (int i = 0; i < lamps.size(); i++) {
            Lamp lamp = lamps.get(i);
            Vec3 p = lamp.position();
            Vec3 relative = p.minus(anchor);
            relative.put(packed, 16 * i, lamp.inverseSquareRange());
            lamp.radiantIntensity().put(packed, 16 * i + 4, lamp.coneScale());
            lamp.axis().put(packed, 16 * i + 8, lamp.coneOffset());
            shadowAxis(lamp).put(packed, 16 * i + 12, layerCode(i));
        }
        return packed;
    }

    private double layerCode(int lamp) {
        int layer = shadows.firstLayer()[lamp];
        return layer >= 0 && LampShadows.hasOwnAxis(lamps.get(lamp)) ? layer + 0.5 : layer;
    }

    private Vec3 shadowAxis(Lamp lamp) {
        double cotangent = LampShadows.cotangent(lamp, shadows.side());
        if (!LampShadows.hasOwnAxis(lamp)) {
            return new Vec3(cotangent, 0, 0);
        }
        Vector3d right = LampShadows.right(lamp).mul(cotangent);
        return new Vec3(right.x, right.y, right.z);
    }

    /** Returns the start of each list, then the lists; starts are indices into the returned array. */
    public int[] packedGrid() {
        int[] first = grid.firstOfList();
        int[] packed = new int[first.length + grid.lamps().length];
        for (int i = 0; i < first.length; i++) {
            packed[i] = first.length + first[i];
        }
        System.arraycopy(grid.lamps(), 0, packed, first.length, grid.lamps().length);
        return packed;
    }
}

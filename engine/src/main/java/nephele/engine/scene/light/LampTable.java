package nephele.engine.scene.light;

import java.util.List;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.Lamp;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Directions;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * Everything about a level's lamps that shaders read.
 *
 * @param shadows layers of the depth texture; none when nothing casts
 */
public record LampTable(List<Lamp> lamps, LampGrid grid, LampShadows shadows) {
    /** Texels of four floats that one lamp takes in {@link #packed}. */
    public static final int TEXELS_PER_LAMP = 4;

    /** @param statics what may be lit and what hides */
    public static LampTable of(List<Light> lights, StaticShapes statics) {
        return of(lights, statics.bounds(), statics);
    }

    /** @param bounds of what may be lit */
    static LampTable of(List<Light> lights, Aabb bounds, StaticShapes statics) {
        List<Lamp> lamps =
                lights.stream().flatMap(light -> Lamp.of(light).stream()).toList();
        LampShadows shadows = LampShadows.of(lamps);
        LampOcclusion hiding = new LampOcclusion(statics, lamps, shadows.firstLayer());
        return new LampTable(lamps, LampGrid.of(lamps, bounds, hiding), shadows);
    }

    /**
     * Per lamp: position and 1/range²; intensity and cone scale; axis and cone offset; the shadow picture's right axis
     * times its cotangent (the cotangent alone for six pictures), and the first layer – plus ½ where it is the only one,
     * −1 without a shadow.
     */
    public float[] packed(Vec3 anchor) {
        float[] packed = new float[lamps.size() * TEXELS_PER_LAMP * 4];
        for (int i = 0; i < lamps.size(); i++) {
            Lamp lamp = lamps.get(i);
            Vec3 p = lamp.position();
            Vec3 relative = Directions.between(anchor, p);
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

    /** Start of each list, then the lists: starts count from the first list. */
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

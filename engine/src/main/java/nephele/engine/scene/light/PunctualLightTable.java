package nephele.engine.scene.light;

import java.util.List;
import java.util.Map;
import nephele.engine.level.Level;
import nephele.engine.level.Light;
import nephele.engine.level.appearance.PunctualLight;
import nephele.engine.level.placed.StaticShapes;
import nephele.engine.math.Aabb;
import nephele.engine.math.Vec3;
import org.joml.Vector3d;

/**
 * All data about a level's punctual lights that shaders read.
 *
 * @param shadows layers of the depth texture; none if no light casts shadows
 */
public record PunctualLightTable(List<PunctualLight> lights, LightGrid grid, LightShadowLayers shadows) {
    /** The number of texels (of four floats) per light in {@link #packed}. */
    public static final int TEXELS_PER_LIGHT = 4;

    private static final Aabb NOTHING_LIT = new Aabb(0, 0, 0, 1, 1, 1);

    /**
     * Makes the table of a level.
     *
     * @param statics shapes that are lit and that cast shadows
     * @return {@code null} if no light reaches anything
     */
    public static PunctualLightTable of(Level level, StaticShapes statics) {
        return edited(null, level, statics);
    }

    /**
     * Makes the table of an edited level; returns the same object if nothing in it has changed, and reuses the parts
     * that no change affects.
     *
     * @param before {@code null} if there is none
     * @return {@code null} if no light reaches anything
     */
    public static PunctualLightTable edited(PunctualLightTable before, Level level, StaticShapes statics) {
        if (!LightRequirements.lights(level)) {
            return null;
        }
        List<PunctualLight> lights = punctual(level.lights());
        if (before == null) {
            return of(lights, statics.bounds(), statics, null);
        }
        return before.grid.isOf(lights, statics) ? before : of(lights, statics.bounds(), statics, before.grid);
    }

    /**
     * Makes a table from lights.
     *
     * @param bounds of the surfaces to light
     */
    static PunctualLightTable of(List<Light> lights, Aabb bounds, StaticShapes statics) {
        return of(punctual(lights), bounds, statics, null);
    }

    private static List<PunctualLight> punctual(List<Light> lights) {
        return lights.stream()
                .flatMap(light -> PunctualLight.of(light).stream())
                .toList();
    }

    private static PunctualLightTable of(
            List<PunctualLight> lights, Aabb bounds, StaticShapes statics, LightGrid before) {
        LightShadowLayers shadows = LightShadowLayers.of(lights);
        Aabb box = bounds.isEmpty() ? NOTHING_LIT : bounds;
        LightGrid grid = LightGrid.of(lights, shadows.firstLayer(), box, statics, before);
        return new PunctualLightTable(lights, grid, shadows);
    }

    /** Returns the same table in which only the {@code lights} most powerful lights cast shadows. */
    public PunctualLightTable withMostShadows(int lights) {
        LightShadowLayers fewer = shadows.ofMostPowerful(lights);
        return fewer == shadows ? this : new PunctualLightTable(this.lights, grid, fewer);
    }

    /**
     * Returns a token for everything that may cast a shadow in a light: the same object after an edit as long as
     * neither the light nor anything within its range has changed.
     */
    public Object shadowToken(int light) {
        return grid.lit(light);
    }

    /**
     * Returns four texels per light: position and 1/range²; intensity and cone scale; axis and cone offset; the shadow
     * picture's right axis times its cotangent (the cotangent alone for six pictures), and the first layer, plus ½ if
     * it is the only one, −1 without a shadow.
     *
     * @param gains of layers by their names; 1 for others
     */
    public float[] packed(Vec3 anchor, Map<String, Double> gains) {
        float[] packed = new float[lights.size() * TEXELS_PER_LIGHT * 4];
        for (int i = 0; i < lights.size(); i++) {
            PunctualLight light = lights.get(i);
            Vec3 p = light.position();
            Vec3 relative = p.minus(anchor);
            relative.put(packed, 16 * i, light.inverseSquareRange());
            double gain = gains.getOrDefault(layer(light), 1.0);
            light.radiantIntensity().scaled(gain).put(packed, 16 * i + 4, light.coneScale());
            light.axis().put(packed, 16 * i + 8, light.coneOffset());
            shadowAxis(light).put(packed, 16 * i + 12, layerCode(i));
        }
        return packed;
    }

    /** Same as {@link #packed(Vec3, Map)}, with all layers as bright as written. */
    public float[] packed(Vec3 anchor) {
        return packed(anchor, Map.of());
    }

    private static String layer(PunctualLight light) {
        return light.source().layer() == null ? "" : light.source().layer();
    }

    private double layerCode(int light) {
        int layer = shadows.firstLayer()[light];
        return layer >= 0 && LightShadowLayers.hasOwnAxis(lights.get(light)) ? layer + 0.5 : layer;
    }

    private Vec3 shadowAxis(PunctualLight light) {
        double cotangent = LightShadowLayers.cotangent(light, shadows.side());
        if (!LightShadowLayers.hasOwnAxis(light)) {
            return new Vec3(cotangent, 0, 0);
        }
        Vector3d right = LightShadowLayers.right(light).mul(cotangent);
        return new Vec3(right.x, right.y, right.z);
    }

    /** Returns the start of each list, then the lists; starts are indices into the returned array. */
    public int[] packedGrid() {
        int[] first = grid.firstOfList();
        int[] packed = new int[first.length + grid.lights().length];
        for (int i = 0; i < first.length; i++) {
            packed[i] = first.length + first[i];
        }
        System.arraycopy(grid.lights(), 0, packed, first.length, grid.lights().length);
        return packed;
    }
}
